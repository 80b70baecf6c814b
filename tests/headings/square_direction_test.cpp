// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/headings/square_direction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/scan/scan_to_points.hpp"
#include "tests/scan/random_points.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare::square_direction_test {

using testing::Fan;
using testing::l_shaped_room;
using testing::scan_of_walls;

constexpr double kSquare = 0.5 * kPi;

SquareDirections directions_of(const Scan& scan) {
  return square_directions(points_from_scan(scan), scan.bearing_step_rad);
}

class SquareDirectionsOnFans : public ::testing::TestWithParam<Fan> {};

TEST_P(SquareDirectionsOnFans, IsTheHeadingModuloARightAngle) {
  for (int turn_deg = -180; turn_deg < 180; turn_deg += 17) {
    const Pose2 T_world_sensor{2.0, 2.5, rad_from_deg(turn_deg)};
    const SquareDirections directions =
        directions_of(scan_of_walls(l_shaped_room(), T_world_sensor, GetParam(), 0.01));
    ASSERT_FALSE(directions.peaks.empty());
    const SquareDirection& best = directions.peaks.front();
    EXPECT_NEAR(
        wrap_to_period(best.theta_rad - T_world_sensor.theta_rad, kSquare), 0.0, rad_from_deg(0.4))
        << turn_deg;
    EXPECT_GE(best.theta_rad, 0.0);
    EXPECT_LT(best.theta_rad, kSquare);
    EXPECT_GT(best.sharpness, 5.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Fans,
                         SquareDirectionsOnFans,
                         ::testing::Values(Fan{360, -kPi, rad_from_deg(1.0)},
                                           Fan{180, -0.5 * kPi, rad_from_deg(1.0)},
                                           Fan{1081, rad_from_deg(-135.0), rad_from_deg(0.25)},
                                           Fan{720, kPi, rad_from_deg(-0.5)}));

TEST(SquareDirections, RotateWithTheScanModuloARightAngle) {
  const Scan scan = scan_of_walls(l_shaped_room(), {2.0, 2.5, 0.2}, {}, 0.01);
  const PointSet points = points_from_scan(scan);
  const double before_rad =
      square_directions(points, scan.bearing_step_rad).peaks.front().theta_rad;
  for (const double turn_rad : {1e-4, 0.3, 1.0, kSquare, -2.0}) {
    const PointSet turned = testing::seen_after_turn(points, turn_rad);
    const double after_rad =
        square_directions(turned, scan.bearing_step_rad).peaks.front().theta_rad;
    // The density's bins turn the starts, the mean hardly changes.
    EXPECT_NEAR(wrap_to_period(after_rad - before_rad - turn_rad, kSquare), 0.0, 1e-4);
  }
}

TEST(SquareDirections, SigmaCoversTheErrorOfNoisyScans) {
  int num_covered = 0;
  constexpr int kNumScans = 200;
  for (int i = 0; i < kNumScans; ++i) {
    const Pose2 T_world_sensor{1.5 + 0.005 * i, 2.5, 0.031 * i};
    const auto directions = directions_of(
        scan_of_walls(l_shaped_room(), T_world_sensor, {}, 0.02, static_cast<std::uint64_t>(i)));
    ASSERT_FALSE(directions.peaks.empty());
    const SquareDirection& best = directions.peaks.front();
    EXPECT_GT(best.sigma_rad, 0.0);
    EXPECT_LT(best.sigma_rad, rad_from_deg(3.0));
    const double error_rad = wrap_to_period(best.theta_rad - T_world_sensor.theta_rad, kSquare);
    num_covered += std::abs(error_rad) <= 2.0 * best.sigma_rad ? 1 : 0;
  }
  EXPECT_GE(num_covered, kNumScans * 9 / 10);
}

TEST(SquareDirections, ListBothFamiliesOfABuildingWithAnObliqueWing) {
  std::vector<testing::Wall> walls = l_shaped_room();
  walls.push_back({1.0, 4.0, 1.0 + 2.5 * std::cos(0.6), 4.0 + 2.5 * std::sin(0.6)});
  const auto directions =
      directions_of(scan_of_walls(walls, {2.0, 2.0, 0.0}, {360, -kPi, rad_from_deg(1.0)}));
  ASSERT_GE(directions.peaks.size(), 2U);
  EXPECT_NEAR(wrap_to_period(directions.peaks[0].theta_rad, kSquare), 0.0, rad_from_deg(0.4));
  EXPECT_NEAR(wrap_to_period(directions.peaks[1].theta_rad + 0.6, kSquare), 0.0, rad_from_deg(1.0));
  EXPECT_GT(directions.margin(), 1.0);
  EXPECT_LT(directions.margin(), 100.0);
}

TEST(SquareDirections, ARoundRoomHasNoMargin) {
  Scan scan = scan_of_walls({}, {}, {360, -kPi, rad_from_deg(1.0)});
  for (double& range_m : scan.ranges_m) range_m = 3.0;
  EXPECT_LT(directions_of(scan).margin(), 1.5);
}

TEST(SquareDirections, OfNothingStraightAreNone) {
  EXPECT_TRUE(directions_of(Scan{}).peaks.empty());
  EXPECT_EQ(directions_of(Scan{}).margin(), 0.0);
  Scan scan = scan_of_walls({}, {});
  EXPECT_TRUE(directions_of(scan).peaks.empty());  // No return at all.
  scan.ranges_m.assign(180, std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(directions_of(scan).peaks.empty());
  scan.ranges_m.assign(1, 2.0);
  EXPECT_TRUE(directions_of(scan).peaks.empty());
  PointSet same;  // A sensor that sees its own bumper.
  for (int i = 0; i < 20; ++i) same.push_back(1.0, 1.0, i);
  for (const SquareDirection& peak : square_directions(same, 0.01).peaks) {
    EXPECT_TRUE(std::isfinite(peak.theta_rad));
  }
}

TEST(SquareDirectionParams, NamesTheFieldThatIsOutsideItsDomain) {
  EXPECT_NO_THROW(SquareDirectionParams{}.validate());
  EXPECT_THROW((SquareDirectionParams{.inlier_rad = 0.0}.validate()), ParameterError);
  EXPECT_THROW((SquareDirectionParams{.pair_weight = -1.0}.validate()), ParameterError);
}

}  // namespace setsquare::square_direction_test
