// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/map_views.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <random>
#include <thread>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/grid/grid_from_scans.hpp"
#include "setsquare/localisation/known_map.hpp"
#include "setsquare/localisation/localizer.hpp"
#include "setsquare/localisation/locate_scan.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::map_views_test {

constexpr testing::Fan kFan{541, -0.75 * kPi, rad_from_deg(0.5)};

Scan scan_at(const testing::FurnishedRoom& room, const Pose2& T, std::mt19937_64& generator) {
  return testing::scan_of_walls(room.walls, T, kFan, 0.01, generator(), 0.02);
}

/// Scans of a furnished room at known places.
struct SeenRoom {
  testing::FurnishedRoom room;
  std::vector<Scan> scans;
  std::vector<PlacedScan> placed;
};

SeenRoom seen_room(int num_scans, std::mt19937_64& generator) {
  SeenRoom seen{testing::furnished_room(generator), {}, {}};
  std::vector<Pose2> poses;
  for (int i = 0; i < num_scans; ++i) {
    poses.push_back(testing::free_pose(seen.room, generator));
    seen.scans.push_back(scan_at(seen.room, poses.back(), generator));
  }
  for (std::size_t i = 0; i < poses.size(); ++i) seen.placed.push_back({&seen.scans[i], poses[i]});
  return seen;
}

MapViews views_of(const SeenRoom& seen, const Pose2& T_map_grid) {
  std::vector<MapViews::SharedScan> shared;
  for (const PlacedScan& placed : seen.placed) {
    shared.push_back({std::make_shared<const Scan>(*placed.scan), placed.T_map_sensor});
  }
  return {shared, T_map_grid};
}

TEST(SeenByViews, ExplainAScanAtItsPlaceAndContradictItElsewhere) {
  auto generator = testing::make_generator();
  for (int k = 0; k < 10; ++k) {
    const SeenRoom seen = seen_room(8, generator);
    const Pose2 T_map_grid{3.0, -2.0, 0.7};
    const MapViews views = views_of(seen, T_map_grid);
    const Pose2 truth = testing::free_pose(seen.room, generator);
    const PreparedScan scan = prepare(scan_at(seen.room, truth, generator));
    // It is laid onto the walls first.
    const Pose2 near = T_map_grid.inverse() * truth * Pose2{0.05, -0.03, rad_from_deg(1.0)};
    const SeenByViews there = seen_by_views(views, scan, near);
    EXPECT_EQ(there.num_views, 8U);
    EXPECT_GT(there.tight_m, 0.5 * there.wall_m);
    EXPECT_GT(there.tight_m, 0.9 * there.loose_m);
    EXPECT_LT(there.through_m, 0.05 * there.wall_m);
    EXPECT_LT(there.distance_m, 0.02);
    const SeenByViews turned = seen_by_views(views, scan, near * Pose2{0.0, 0.0, 0.5 * kPi});
    EXPECT_LT(turned.tight_m, 0.8 * there.tight_m);
    EXPECT_GT(turned.through_m + turned.missed_m, there.through_m + there.missed_m);
  }
}

TEST(SeenByViews, TellNothingOfAPlaceThatNoneIsNear) {
  auto generator = testing::make_generator();
  const SeenRoom seen = seen_room(3, generator);
  const MapViews views = views_of(seen, {});
  const PreparedScan scan = prepare(seen.scans.front());
  EXPECT_EQ(seen_by_views(views, scan, {100.0, 0.0, 0.0}).num_views, 0U);
  EXPECT_EQ(seen_by_views({}, scan, {}).num_views, 0U);
}

// Each is made once, by whichever thread asks first, and is what its scan is prepared to.
TEST(MapViews, AreMadeOnceWhenThreadsAskForThem) {
  auto generator = testing::make_generator();
  const SeenRoom seen = seen_room(8, generator);
  const Pose2 T_map_grid{1.0, 2.0, 0.3};
  const MapViews views = views_of(seen, T_map_grid);
  ASSERT_EQ(views.size(), seen.scans.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    EXPECT_EQ(views.T_grid_sensor(i), T_map_grid.inverse() * seen.placed[i].T_map_sensor);
  }
  EXPECT_EQ(views.num_made(), 0U);
  constexpr std::size_t kNumThreads = 4;
  std::array<std::vector<const MapView*>, kNumThreads> asked;
  std::vector<std::jthread> threads;
  for (std::size_t k = 0; k < kNumThreads; ++k) {
    threads.emplace_back([&, k] {
      const MapViews shared = views;
      for (std::size_t i = 0; i < shared.size(); ++i) asked[k].push_back(&shared[i]);
    });
  }
  threads.clear();
  EXPECT_EQ(views.num_made(), views.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    EXPECT_EQ(views[i].fine.x_m, prepare(seen.scans[i]).fine.x_m);
    for (const auto& by_thread : asked) EXPECT_EQ(by_thread[i], &views[i]);
  }
}

TEST(MapViews, AreNotMadeOfAScanThatIsNone) {
  auto invalid = std::make_shared<Scan>();
  invalid->ranges_m = {1.0, 1.0};
  const std::vector<MapViews::SharedScan> scans{{invalid, {}}};
  EXPECT_THROW(MapViews(scans, {}), ParameterError);
}

// Where no place is in doubt its scans are not looked at.
TEST(MapViews, OfAKnownMapAreMadeWhereAPlaceIsInDoubt) {
  auto generator = testing::make_generator();
  const SeenRoom seen = seen_room(6, generator);
  const KnownMap map(grid_from_scans(seen.placed), seen.placed);
  EXPECT_EQ(map.views().size(), seen.scans.size());
  EXPECT_EQ(map.views().num_made(), 0U);
  LocalisationParams sure;
  sure.min_probability_at_once = 0.0;
  (void)locate_scan(map, seen.scans.front(), sure);
  EXPECT_EQ(map.views().num_made(), 0U);
  LocalisationParams never_sure;
  never_sure.min_probability_at_once = 1.0;
  (void)locate_scan(map, seen.scans.front(), never_sure);
  EXPECT_GT(map.views().num_made(), 0U);
}

/// Of scans in rooms of which three scans leave something unmapped: how many are localised by the
/// grid alone and by the map's scans, too, and how many of these wrongly.
struct LocalisedScans {
  int num = 60;
  int num_by_grid = 0;
  int num_by_scans = 0;
  int num_wrong = 0;
};

/// `locate`: a known map and a scan -> the scan's pose where it is localised, or nothing.
template <typename Locate>
LocalisedScans localised_in_rooms(const Locate& locate) {
  auto generator = testing::make_generator();
  constexpr int kNumInRoom = 5;
  LocalisedScans localised;
  for (int k = 0; k < localised.num / kNumInRoom; ++k) {
    const SeenRoom seen = seen_room(3, generator);
    const OccupancyGrid grid = grid_from_scans(seen.placed);
    const auto by_grid = std::make_shared<const KnownMap>(grid);
    const auto by_scans = std::make_shared<const KnownMap>(grid, seen.placed);
    for (int i = 0; i < kNumInRoom; ++i) {
      const Pose2 truth = testing::free_pose(seen.room, generator);
      const Scan scan = scan_at(seen.room, truth, generator);
      localised.num_by_grid += locate(by_grid, scan).has_value();
      const std::optional<Pose2> T_map_sensor = locate(by_scans, scan);
      if (!T_map_sensor) continue;
      ++localised.num_by_scans;
      const Pose2 error = truth.inverse() * *T_map_sensor;
      localised.num_wrong +=
          error.translation().norm() > 0.1 || std::abs(error.theta_rad) > rad_from_deg(2.0);
    }
  }
  return localised;
}

TEST(MapViews, TellApartWhatIsAlikeInItsGrid) {
  const LocalisedScans localised = localised_in_rooms([](const auto& map, const Scan& scan) {
    const LocatedScan located = locate_scan(*map, scan);
    const bool is_localised = located.status == LocalisationStatus::kLocalised;
    return is_localised ? std::optional(located.places.front().T_map_sensor) : std::nullopt;
  });
  EXPECT_LE(localised.num_wrong, 1);
  EXPECT_GE(localised.num_by_scans, localised.num_by_grid + localised.num / 20)
      << localised.num_by_grid << " by the grid alone";
}

TEST(MapViews, TellALocalizerWhereItBegins) {
  const LocalisedScans localised = localised_in_rooms([](const auto& map, const Scan& scan) {
    const LocalisedPose pose = Localizer(map).add(scan);
    const bool is_localised = pose.status == LocalisationStatus::kLocalised;
    return is_localised ? std::optional(pose.T_map_sensor) : std::nullopt;
  });
  EXPECT_LE(localised.num_wrong, 1);
  EXPECT_GT(localised.num_by_scans, localised.num_by_grid);
}

}  // namespace setsquare::map_views_test
