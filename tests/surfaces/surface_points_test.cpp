// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/surfaces/surface_points.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "setsquare/core/error.hpp"
#include "tests/support/rectangular_room.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::surface_points_test {

using testing::Fan;
using testing::scan_of_walls;
using testing::uniform;

const Fan kFullTurn{720, -kPi, rad_from_deg(0.5)};

/// The same beams in the other order.
Scan reversed(const Scan& scan) {
  Scan reversed = scan;
  reversed.first_bearing_rad = scan.bearing_rad(scan.num_beams() - 1);
  reversed.bearing_step_rad = -scan.bearing_step_rad;
  reversed.ranges_m.assign(scan.ranges_m.rbegin(), scan.ranges_m.rend());
  return reversed;
}

TEST(SurfacePoints, AreTheReturnsInTheirPlaces) {
  auto generator = testing::make_generator();
  const auto room = testing::furnished_room(generator);
  const Scan scan =
      scan_of_walls(room.walls, testing::free_pose(room, generator), kFullTurn, 0.02, 1, 0.3);
  const SurfacePoints points = surface_points_from_scan(scan);
  std::size_t i = 0;
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    if (scan.outcome(beam) != BeamOutcome::kReturn) continue;
    ASSERT_LT(i, points.size());
    EXPECT_EQ(points.beam[i], static_cast<int>(beam));
    EXPECT_NEAR(points.x_m[i], scan.ranges_m[beam] * std::cos(scan.bearing_rad(beam)), 1e-5);
    EXPECT_NEAR(points.y_m[i], scan.ranges_m[beam] * std::sin(scan.bearing_rad(beam)), 1e-5);
    ++i;
  }
  EXPECT_EQ(i, points.size());
}

TEST(SurfacePoints, NormalsAreUnitOrNoneAndFaceTheSensor) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 10; ++trial) {
    const auto room = testing::furnished_room(generator);
    const Scan scan = scan_of_walls(
        room.walls, testing::free_pose(room, generator), kFullTurn, 0.02, generator(), 0.1);
    const SurfacePoints points = surface_points_from_scan(scan);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double length = std::hypot(points.normal_x[i], points.normal_y[i]);
      EXPECT_TRUE(length == 0.0 || std::abs(length - 1.0) < 1e-5) << length;
      EXPECT_LE(points.normal_x[i] * points.x_m[i] + points.normal_y[i] * points.y_m[i], 1e-6F);
      EXPECT_GT(points.weight_m[i], 0.0F);
      EXPECT_LE(points.weight_m[i], 0.2F);
    }
  }
}

TEST(SurfacePoints, NormalsOfAHexagonAreThoseOfItsWalls) {
  const SurfacePoints points = surface_points_from_scan(
      scan_of_walls(testing::regular_polygon(6, 4.0), {0.5, -0.3, 0.0}, kFullTurn));
  std::size_t num_astray = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_TRUE(points.normal_x[i] != 0.0F || points.normal_y[i] != 0.0F);
    // Walls of a hexagon with a corner at 0 deg face 30, 90, 150 deg ...
    const double bearing_rad = std::atan2(points.normal_y[i], points.normal_x[i]);
    num_astray += std::abs(wrap_to_period(bearing_rad - kPi / 6, kPi / 3)) > rad_from_deg(0.5);
  }
  EXPECT_LE(num_astray, 6U * 8U);  // A few at each corner.
  EXPECT_LE(points.size() -
                static_cast<std::size_t>(std::count(points.joined.begin(), points.joined.end(), 1)),
            1U);  // Nothing ends but the sweep.
}

TEST(SurfacePoints, SurfacesEndWhereTheRangeJumps) {
  // A post in front of a wall.
  const std::vector<testing::Wall> walls = {{-4, 3, 4, 3}, {-0.1, 1.5, 0.1, 1.5}};
  const SurfacePoints points =
      surface_points_from_scan(scan_of_walls(walls, {}, {91, kPi / 4, rad_from_deg(1)}));
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    EXPECT_EQ(points.joined[i] != 0, std::abs(points.y_m[i + 1] - points.y_m[i]) < 1.0F) << i;
  }
}

TEST(SurfacePoints, BridgesMissingBeamsOfAWallButNotADoor) {
  Scan wall = scan_of_walls({{-9, 2, 9, 2}}, {}, {91, kPi / 4, rad_from_deg(1)});
  wall.ranges_m[45] = 0.0;
  SurfacePoints points = surface_points_from_scan(wall);
  EXPECT_EQ(points.joined[44], 1);
  for (std::size_t beam = 40; beam < 50; ++beam) wall.ranges_m[beam] = 81.83;
  points = surface_points_from_scan(wall);
  EXPECT_EQ(points.beam[39], 39);
  EXPECT_EQ(points.joined[39], 0);
}

TEST(SurfacePoints, DoNotDependOnTheRotationSense) {
  auto generator = testing::make_generator();
  const auto room = testing::furnished_room(generator);
  const Scan scan = scan_of_walls(room.walls, testing::free_pose(room, generator), kFullTurn, 0.01);
  const SurfacePoints forth = surface_points_from_scan(scan);
  const SurfacePoints back = surface_points_from_scan(reversed(scan));
  ASSERT_EQ(back.size(), forth.size());
  for (std::size_t i = 0; i < forth.size(); ++i) {
    const std::size_t k = forth.size() - 1 - i;
    EXPECT_NEAR(back.x_m[k], forth.x_m[i], 1e-5);
    EXPECT_NEAR(back.y_m[k], forth.y_m[i], 1e-5);
    EXPECT_NEAR(back.weight_m[k], forth.weight_m[i], 1e-5);
    EXPECT_NEAR(back.normal_x[k], forth.normal_x[i], 1e-3) << i;
    EXPECT_NEAR(back.normal_y[k], forth.normal_y[i], 1e-3) << i;
  }
}

/// Share of the returns that a line fits, and how far off their lines' directions are (mean, rad),
/// in the middle of a square room.
struct LinesOfRoom {
  double share = 0.0;
  double mean_off_rad = 0.0;
};

LinesOfRoom lines_of_room(double noise_m, const SurfaceParams& params) {
  constexpr int kNumScans = 10;
  constexpr double kHalfRoom_m = 2.0;
  auto generator = testing::make_generator();
  const Scan exact = testing::scan_of_room(
      {kHalfRoom_m, kHalfRoom_m, 0.0}, 2.0 * kHalfRoom_m, 2.0 * kHalfRoom_m, kFullTurn.num_beams);
  std::normal_distribution<double> noise(0.0, noise_m);
  std::size_t num_returns = 0;
  std::size_t num_lines = 0;
  double sum_off_rad = 0.0;
  for (int i = 0; i < kNumScans; ++i) {
    Scan scan = exact;
    for (double& range_m : scan.ranges_m) range_m += noise(generator);
    const SurfacePoints points = surface_points_from_scan(scan, params);
    num_returns += points.size();
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (points.normal_x[k] == 0.0F && points.normal_y[k] == 0.0F) continue;
      const double direction_rad = std::atan2(points.normal_y[k], points.normal_x[k]);
      ++num_lines;
      sum_off_rad += std::abs(std::remainder(direction_rad, 0.5 * kPi));
    }
  }
  return {static_cast<double>(num_lines) / static_cast<double>(num_returns),
          sum_off_rad / static_cast<double>(num_lines)};
}

TEST(SurfacePoints, ANoisyScannerHasLinesAlongItsWalls) {
  const LinesOfRoom lines = lines_of_room(0.05, {});
  EXPECT_GT(lines.share, 0.9);
  EXPECT_LT(lines.mean_off_rad, rad_from_deg(3.0));
}

TEST(SurfacePoints, StayFiniteWhateverTheRanges) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInf = std::numeric_limits<double>::infinity();
  auto generator = testing::make_generator();
  const std::vector<double> odd_m{
      kNaN, kInf, -kInf, 0.0, -1.0, 5e-324, 1e-42, 1e-12, 0.004, 3.0, 3.0, 29.999999, 30.0, 1e300};
  for (int trial = 0; trial < 200; ++trial) {
    Scan scan;
    scan.first_bearing_rad = uniform(generator, -kPi, kPi);
    scan.bearing_step_rad = uniform(generator, -0.1, 0.1);
    for (int beam = 0; beam < 60; ++beam) {
      scan.ranges_m.push_back(odd_m[generator() % odd_m.size()]);
    }
    const SurfacePoints points = surface_points_from_scan(scan);
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (const float value : {points.x_m[i],
                                points.y_m[i],
                                points.normal_x[i],
                                points.normal_y[i],
                                points.weight_m[i]}) {
        ASSERT_TRUE(std::isfinite(value));
      }
      ASSERT_LE(points.range_m[i], 30.0F);
    }
  }
}

TEST(SurfaceParams, NamesTheFieldThatIsOutsideItsDomain) {
  EXPECT_NO_THROW(SurfaceParams{}.validate());
  const auto complaint = [](const SurfaceParams& params) -> std::string {
    try {
      params.validate();
    } catch (const ParameterError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(complaint({.max_range_m = 0.0}), ::testing::HasSubstr("max_range_m"));
  EXPECT_THAT(complaint({.join_distance_m = -1.0}), ::testing::HasSubstr("join_distance_m"));
  EXPECT_THAT(complaint({.join_beam_spacings = 0.0}), ::testing::HasSubstr("join_beam_spacings"));
  EXPECT_THAT(complaint({.collinear_tolerance_m = 0.0}),
              ::testing::HasSubstr("collinear_tolerance_m"));
  EXPECT_THAT(complaint({.max_join_m = 0.0}), ::testing::HasSubstr("max_join_m"));
  EXPECT_THAT(complaint({.fit_radius_m = std::nan("")}), ::testing::HasSubstr("fit_radius_m"));
  EXPECT_THAT(complaint({.max_fit_rms_m = 0.0}), ::testing::HasSubstr("max_fit_rms_m"));
  EXPECT_THAT(complaint({.max_weight_m = 0.0}), ::testing::HasSubstr("max_weight_m"));
}

}  // namespace setsquare::surface_points_test
