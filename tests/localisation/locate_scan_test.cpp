// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/locate_scan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/grid/grid_from_scans.hpp"
#include "setsquare/localisation/known_map.hpp"
#include "setsquare/localisation/place_search.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::locate_scan_test {

constexpr testing::Fan kFan{541, -0.75 * kPi, rad_from_deg(0.5)};

Scan scan_at(const std::vector<testing::Wall>& walls, const Pose2& T, std::mt19937_64& generator) {
  return testing::scan_of_walls(walls, T, kFan, 0.01, generator(), 0.02);
}

/// The grid of scans taken at these poses.
OccupancyGrid grid_of(const std::vector<testing::Wall>& walls,
                      const std::vector<Pose2>& poses,
                      std::mt19937_64& generator) {
  std::vector<Scan> scans;
  for (const Pose2& pose : poses) scans.push_back(scan_at(walls, pose, generator));
  std::vector<PlacedScan> placed;
  for (std::size_t i = 0; i < scans.size(); ++i) placed.push_back({&scans[i], poses[i]});
  return grid_from_scans(placed);
}

/// A furnished room and the map of it.
struct MappedRoom {
  testing::FurnishedRoom room;
  OccupancyGrid grid;
};

MappedRoom mapped_room(std::mt19937_64& generator) {
  testing::FurnishedRoom room = testing::furnished_room(generator);
  std::vector<Pose2> poses;
  for (int i = 0; i < 12; ++i) poses.push_back(testing::free_pose(room, generator));
  OccupancyGrid grid = grid_of(room.walls, poses, generator);
  return {std::move(room), std::move(grid)};
}

double distance_m(const Pose2& a, const Pose2& b) {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

TEST(LocateScan, FindsScansOfAFurnishedRoomAndIsNeverSurelyWrong) {
  auto generator = testing::make_generator();
  int num_localised = 0;
  int num_right = 0;
  constexpr int kNumRooms = 8;
  constexpr int kNumScans = 6;
  for (int k = 0; k < kNumRooms; ++k) {
    const MappedRoom mapped = mapped_room(generator);
    const KnownMap map(mapped.grid);
    for (int i = 0; i < kNumScans; ++i) {
      const Pose2 truth = testing::free_pose(mapped.room, generator);
      const LocatedScan located = locate_scan(map, scan_at(mapped.room.walls, truth, generator));
      ASSERT_FALSE(located.places.empty());
      const PossiblePlace& best = located.places.front();
      const bool is_right =
          distance_m(best.T_map_sensor, truth) < 0.1 &&
          std::abs(wrap_to_pi(best.T_map_sensor.theta_rad - truth.theta_rad)) < rad_from_deg(2.0);
      num_right += is_right;
      num_localised += located.status == LocalisationStatus::kLocalised;
      EXPECT_TRUE(is_right || located.status != LocalisationStatus::kLocalised);
    }
  }
  EXPECT_GE(num_right, kNumRooms * kNumScans * 95 / 100);
  EXPECT_GE(num_localised, kNumRooms * kNumScans * 7 / 10);
}

TEST(LocateScan, ErrorsLieWithinThreeOfTheirSpread) {
  auto generator = testing::make_generator();
  for (int k = 0; k < 4; ++k) {
    const MappedRoom mapped = mapped_room(generator);
    const KnownMap map(mapped.grid);
    for (int i = 0; i < 6; ++i) {
      const Pose2 truth = testing::free_pose(mapped.room, generator);
      const LocatedScan located = locate_scan(map, scan_at(mapped.room.walls, truth, generator));
      if (located.status != LocalisationStatus::kLocalised) continue;
      const PossiblePlace& best = located.places.front();
      EXPECT_LT(std::abs(best.T_map_sensor.x_m - truth.x_m),
                3.0 * std::sqrt(best.covariance(0, 0)));
      EXPECT_LT(std::abs(best.T_map_sensor.y_m - truth.y_m),
                3.0 * std::sqrt(best.covariance(1, 1)));
      EXPECT_LT(std::abs(wrap_to_pi(best.T_map_sensor.theta_rad - truth.theta_rad)),
                3.0 * std::sqrt(best.covariance(2, 2)));
    }
  }
}

TEST(LocateScan, PlacesMoveWithTheMapsFrame) {
  auto generator = testing::make_generator();
  const MappedRoom mapped = mapped_room(generator);
  const Pose2 T_other_map{12.0, -30.0, 1.1};
  OccupancyGrid moved(T_other_map * mapped.grid.T_map_grid(),
                      mapped.grid.resolution_m(),
                      mapped.grid.num_columns(),
                      mapped.grid.num_rows());
  moved.values() = mapped.grid.values();
  const Scan scan =
      scan_at(mapped.room.walls, testing::free_pose(mapped.room, generator), generator);
  const LocatedScan a = locate_scan(KnownMap(mapped.grid), scan);
  const LocatedScan b = locate_scan(KnownMap(moved), scan);
  ASSERT_EQ(a.places.size(), b.places.size());
  EXPECT_EQ(a.status, b.status);
  for (std::size_t i = 0; i < a.places.size(); ++i) {
    const Pose2 expected = T_other_map * a.places[i].T_map_sensor;
    EXPECT_NEAR(distance_m(b.places[i].T_map_sensor, expected), 0.0, 1e-9);
    EXPECT_NEAR(a.places[i].probability, b.places[i].probability, 1e-12);
    const Eigen::Matrix2d before = a.places[i].covariance.topLeftCorner<2, 2>();
    const Eigen::Matrix2d after = b.places[i].covariance.topLeftCorner<2, 2>();
    EXPECT_NEAR(before.trace(), after.trace(), 1e-9);
  }
}

TEST(LocateScan, AnEmptyRectangleIsAmbiguousByAHalfTurn) {
  auto generator = testing::make_generator();
  const auto walls = testing::empty_rectangle(8.0, 5.0);
  std::vector<Pose2> poses;
  for (int i = 0; i < 8; ++i) poses.push_back({1.0 + 0.8 * i, 1.0 + 0.4 * i, 0.7 * i});
  const KnownMap map(grid_of(walls, poses, generator));
  const Pose2 truth{2.5, 1.7, 0.4};
  const testing::Fan whole_turn{720, -kPi, rad_from_deg(0.5)};
  const Scan scan = testing::scan_of_walls(walls, truth, whole_turn, 0.01, generator(), 0.0);
  const LocatedScan located = locate_scan(map, scan);
  EXPECT_NE(located.status, LocalisationStatus::kLocalised);
  ASSERT_GE(located.places.size(), 2U);
  const Pose2 turned{8.0 - truth.x_m, 5.0 - truth.y_m, wrap_to_pi(truth.theta_rad + kPi)};
  const Pose2& first = located.places[0].T_map_sensor;
  const Pose2& second = located.places[1].T_map_sensor;
  EXPECT_LT(std::min(distance_m(first, truth), distance_m(first, turned)), 0.1);
  EXPECT_LT(std::min(distance_m(second, truth), distance_m(second, turned)), 0.1);
  EXPECT_GT(distance_m(first, second), 0.5);
}

TEST(LocateScan, AScanOfAnotherRoomIsNotLocalised) {
  auto generator = testing::make_generator();
  const MappedRoom mapped = mapped_room(generator);
  const KnownMap map(mapped.grid);
  for (int i = 0; i < 10; ++i) {
    const testing::FurnishedRoom other = testing::furnished_room(generator);
    const Scan scan = scan_at(other.walls, testing::free_pose(other, generator), generator);
    EXPECT_NE(locate_scan(map, scan).status, LocalisationStatus::kLocalised);
  }
}

TEST(LocateScan, FindsTheSensorALittleBeyondWhatTheMapKnows) {
  auto generator = testing::make_generator();
  constexpr int kNumRooms = 10;
  int num_right = 0;
  for (int k = 0; k < kNumRooms; ++k) {
    MappedRoom mapped = mapped_room(generator);
    const Pose2 truth = testing::free_pose(mapped.room, generator);
    // Nothing was seen about the place, but the walls were.
    OccupancyGrid& grid = mapped.grid;
    for (std::int32_t row = 0; row < grid.num_rows(); ++row) {
      for (std::int32_t column = 0; column < grid.num_columns(); ++column) {
        const Pose2 at =
            grid.T_map_grid() *
            Pose2{(column + 0.5) * grid.resolution_m(), (row + 0.5) * grid.resolution_m(), 0.0};
        float& value = grid.values()[grid.index({column, row})];
        if (distance_m(at, truth) < 0.8 && value < 0.0F) value = 0.0F;
      }
    }
    const LocatedScan located =
        locate_scan(KnownMap(grid), scan_at(mapped.room.walls, truth, generator));
    num_right +=
        !located.places.empty() && distance_m(located.places.front().T_map_sensor, truth) < 0.1;
  }
  EXPECT_GE(num_right, kNumRooms * 9 / 10);
}

TEST(StatusOf, OneScanMustBeSurerThanAWay) {
  const LocalisationParams params;
  const double between = 0.5 * (params.min_probability + params.min_probability_at_once);
  EXPECT_EQ(status_of(between, params.min_probability, 1.0, params),
            LocalisationStatus::kLocalised);
  EXPECT_EQ(status_of(between, params.min_probability_at_once, 1.0, params),
            LocalisationStatus::kAmbiguous);
  EXPECT_EQ(status_of(0.1, params.min_probability, 0.2, params), LocalisationStatus::kLost);
}

TEST(LocateScan, OfNothingFindsNothing) {
  auto generator = testing::make_generator();
  const MappedRoom mapped = mapped_room(generator);
  Scan blind = scan_at(mapped.room.walls, testing::free_pose(mapped.room, generator), generator);
  for (double& range_m : blind.ranges_m) range_m = std::nan("");
  EXPECT_EQ(locate_scan(KnownMap(mapped.grid), blind).status, LocalisationStatus::kLost);
  const KnownMap nothing(OccupancyGrid({}, 0.05, 10, 10));
  EXPECT_TRUE(nothing.is_empty());
  const Scan scan =
      scan_at(mapped.room.walls, testing::free_pose(mapped.room, generator), generator);
  EXPECT_EQ(locate_scan(nothing, scan).status, LocalisationStatus::kLost);
  Scan invalid = scan;
  invalid.bearing_step_rad = std::nan("");
  EXPECT_THROW((void)locate_scan(nothing, invalid), ParameterError);
}

TEST(VerifiedPlace, FewNoisyReturnsSeldomLeadItAstray) {
  auto generator = testing::make_generator();
  constexpr int kNumRooms = 10;
  constexpr int kNumScans = 10;
  constexpr double kNoise_m = 0.2;
  constexpr double kMissed = 0.85;
  int num_astray = 0;
  int num_astray_without = 0;  // The rule switched off.
  for (int k = 0; k < kNumRooms; ++k) {
    const MappedRoom mapped = mapped_room(generator);
    const KnownMap map(mapped.grid);
    for (int i = 0; i < kNumScans; ++i) {
      const Pose2 truth = testing::free_pose(mapped.room, generator);
      const Scan scan =
          testing::scan_of_walls(mapped.room.walls, truth, kFan, kNoise_m, generator(), kMissed);
      const Pose2 T_grid_sensor = map.T_map_grid().inverse() * truth;
      const auto is_astray = [&](double max_fall) {
        const VerifiedPlace place = verified_place(map, sought_scan(scan), T_grid_sensor, max_fall);
        const Pose2 error = T_grid_sensor.inverse() * place.T_grid_sensor;
        return error.translation().norm() > 0.2 || std::abs(error.theta_rad) > rad_from_deg(2.0);
      };
      num_astray += is_astray(kMaxFallOfFit);
      num_astray_without += is_astray(10.0);
    }
  }
  EXPECT_GT(num_astray_without, kNumRooms * kNumScans / 10);
  EXPECT_LT(num_astray, num_astray_without * 4 / 5);
}

}  // namespace setsquare::locate_scan_test
