// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/mounting.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "setsquare/core/angle.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::mounting_test {

using ros::MountedScans;
using ros::Mounting;
using ros::mounting_from_transform;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::PoseNear;
using testing::PoseTolerance;

Eigen::Isometry3d pose(double x_m, double y_m, double roll_rad, double pitch_rad, double yaw_rad) {
  return Eigen::Translation3d(x_m, y_m, 0.4) *
         Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX());
}

Eigen::Vector3d beam_end(const Scan& scan, std::size_t beam) {
  const double bearing_rad = scan.bearing_rad(beam);
  return scan.ranges_m[beam] * Eigen::Vector3d(std::cos(bearing_rad), std::sin(bearing_rad), 0.0);
}

Scan scan_of(double first_rad, double step_rad, std::size_t num_beams, double range_m) {
  Scan scan;
  scan.first_bearing_rad = first_rad;
  scan.bearing_step_rad = step_rad;
  scan.min_range_m = 0.1;
  scan.max_range_m = 30.0;
  scan.ranges_m.assign(num_beams, range_m);
  return scan;
}

TEST(Mounting, LevelScannersKeepPositionAndYaw) {
  const Mounting mounting = mounting_from_transform(pose(0.2, -0.3, 0.0, 0.0, 1.1));
  EXPECT_THAT(mounting.T_base_sensor, PoseNear(Pose2{0.2, -0.3, 1.1}, PoseTolerance{}));
  EXPECT_FALSE(mounting.is_upside_down);
  EXPECT_TRUE(mounting.is_level());
  EXPECT_THAT(mounting.remark(), IsEmpty());
}

TEST(Mounting, AnyLevelMountingPutsBeamEndsWhereSpaceDoes) {
  auto generator = testing::make_generator();
  for (int round = 0; round < 100; ++round) {
    const bool is_upside_down = round % 2 == 1;
    const double yaw_rad = testing::uniform(generator, -kPi, kPi);
    const Eigen::Isometry3d T_base_sensor = pose(testing::uniform(generator, -1.0, 1.0),
                                                 testing::uniform(generator, -1.0, 1.0),
                                                 is_upside_down ? kPi : 0.0,
                                                 0.0,
                                                 yaw_rad);
    Scan scan = scan_of(-1.5, 0.01, 300, 0.0);
    for (double& range_m : scan.ranges_m) range_m = testing::uniform(generator, 0.5, 20.0);
    const Scan before = scan;
    const Mounting mounting = mounting_from_transform(T_base_sensor);
    EXPECT_EQ(mounting.is_upside_down, is_upside_down);
    MountedScans().mount(mounting, scan);
    for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
      const Eigen::Vector2d in_space = (T_base_sensor * beam_end(before, beam)).head<2>();
      const Eigen::Vector2d in_plane = scan.T_base_sensor * beam_end(scan, beam).head<2>().eval();
      ASSERT_LT((in_space - in_plane).norm(), 1e-9) << beam << " seed " << testing::test_seed();
    }
  }
}

TEST(Mounting, UpsideDownRunsClockwise) {
  Scan scan = scan_of(-1.5, 0.01, 301, 2.0);
  const Mounting mounting = mounting_from_transform(pose(0.0, 0.0, kPi, 0.0, 0.0));
  EXPECT_EQ(mounting.remark(), "the scanner hangs upside down");
  MountedScans().mount(mounting, scan);
  EXPECT_DOUBLE_EQ(scan.first_bearing_rad, 1.5);
  EXPECT_DOUBLE_EQ(scan.bearing_step_rad, -0.01);
}

/// A room of upright walls around the scanner: the range at which a tilted beam meets them.
double wall_distance_m(const Eigen::Vector3d& direction) {
  const double x = direction.x() > 0.0 ? 3.0 / direction.x() : -4.0 / direction.x();
  const double y = direction.y() > 0.0 ? 2.0 / direction.y() : -5.0 / direction.y();
  return std::min(x, y);
}

TEST(Mounting, TiltedScannersSeeUprightWallsWhereTheyAre) {
  for (const double tilt_deg : {1.0, 3.0, 10.0, -20.0, 29.0}) {
    for (const double roll_rad : {0.0, 0.05, kPi, kPi - 0.05}) {
      for (const double span_rad : {kTwoPi, 4.0}) {
        const double step_rad = rad_from_deg(0.25);
        const auto num_beams = static_cast<std::size_t>(std::round(span_rad / step_rad));
        Scan scan = scan_of(-0.5 * span_rad, step_rad, num_beams, 0.0);
        const Eigen::Isometry3d T_base_sensor =
            pose(0.0, 0.0, roll_rad, rad_from_deg(tilt_deg), 0.7);
        for (std::size_t beam = 0; beam < num_beams; ++beam) {
          scan.ranges_m[beam] = 1.0;
          const Eigen::Vector3d ray = T_base_sensor.linear() * beam_end(scan, beam);
          scan.ranges_m[beam] = wall_distance_m(ray);
        }
        MountedScans().mount(mounting_from_transform(T_base_sensor), scan);
        std::size_t num_seen = 0;
        for (std::size_t beam = 0; beam < num_beams; ++beam) {
          if (scan.outcome(beam) != BeamOutcome::kReturn) continue;
          ++num_seen;
          const double bearing_rad = scan.bearing_rad(beam) + scan.T_base_sensor.theta_rad;
          const double expected_m =
              wall_distance_m({std::cos(bearing_rad), std::sin(bearing_rad), 0.0});
          // Half a beam off, on a wall that is met at a flat angle.
          ASSERT_NEAR(scan.ranges_m[beam], expected_m, 0.012 * expected_m)
              << tilt_deg << " " << beam;
        }
        EXPECT_GT(num_seen, num_beams - num_beams / 20);
      }
    }
  }
}

TEST(Mounting, OutcomesOfATiltedScanStay) {
  Scan scan = scan_of(-0.4, 0.1, 9, 5.0);
  scan.ranges_m[1] = std::numeric_limits<double>::infinity();
  scan.ranges_m[3] = 0.1;
  scan.ranges_m[5] = std::numeric_limits<double>::quiet_NaN();
  scan.ranges_m[7] = 30.0;
  Scan mounted = scan;
  MountedScans().mount(mounting_from_transform(pose(0.0, 0.0, 0.0, rad_from_deg(15.0), 0.0)),
                       mounted);
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    EXPECT_EQ(mounted.outcome(beam), scan.outcome(beam)) << beam;
  }
  EXPECT_NEAR(mounted.ranges_m[4], 5.0 * std::cos(rad_from_deg(15.0)), 1e-9);
  EXPECT_EQ(mounted.ranges_m[7], 30.0);
}

TEST(Mounting, WhatIsTiltedIsToldWithItsAngle) {
  EXPECT_THAT(mounting_from_transform(pose(0.0, 0.0, 0.0, rad_from_deg(2.0), 0.0)).remark(),
              IsEmpty());
  const Mounting tilted = mounting_from_transform(pose(0.0, 0.0, 0.0, rad_from_deg(12.0), 0.3));
  EXPECT_THAT(tilted.remark(), HasSubstr("tilted by 12.0 degrees"));
  EXPECT_TRUE(tilted.is_horizontal());
  EXPECT_THAT(tilted.T_base_sensor, PoseNear(Pose2{0.0, 0.0, 0.3}, PoseTolerance{}));
  const Mounting upright = mounting_from_transform(pose(0.0, 0.0, kQuarterTurn, 0.0, 0.0));
  EXPECT_FALSE(upright.is_horizontal());
  EXPECT_THAT(upright.remark(), HasSubstr("not horizontal: its plane is tilted by 90 degrees"));
}

TEST(Mounting, GeometryThatChangesIsWorkedOutAnew) {
  const Mounting mounting = mounting_from_transform(pose(0.0, 0.0, 0.0, rad_from_deg(10.0), 0.0));
  MountedScans used;
  Scan first = scan_of(-1.0, 0.01, 200, 5.0);
  used.mount(mounting, first);
  for (const std::size_t num_beams : {std::size_t{1}, std::size_t{0}, std::size_t{150}}) {
    Scan again = scan_of(-1.2, 0.015, num_beams, 5.0);
    Scan fresh = again;
    used.mount(mounting, again);
    MountedScans().mount(mounting, fresh);
    for (std::size_t beam = 0; beam < num_beams; ++beam) {
      const bool is_same = again.ranges_m[beam] == fresh.ranges_m[beam] ||
                           (std::isnan(again.ranges_m[beam]) && std::isnan(fresh.ranges_m[beam]));
      EXPECT_TRUE(is_same);
    }
  }
}

TEST(Mounting, PlanarPoseLeavesTheTiltOut) {
  const Pose2 planar = ros::planar_pose(pose(1.0, 2.0, 0.03, -0.04, 2.5));
  EXPECT_THAT(planar, PoseNear(Pose2{1.0, 2.0, 2.5}, PoseTolerance{1e-9, 2e-3}));
}

}  // namespace setsquare::mounting_test
