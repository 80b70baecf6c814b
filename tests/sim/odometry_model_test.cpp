// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/sensing/odometry_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "tests/support/pose_matchers.hpp"

namespace setsquare::odometry_model_test {

using testing::PoseNear;

/// Pose on a circle of 2 m that begins somewhere in the map, after `way_m` along it.
Pose2 pose_on_circle(double way_m) {
  constexpr double kRadius_m = 2.0;
  const double turn_rad = way_m / kRadius_m;
  const Pose2 T_map_start{3.0, -4.0, 1.0};
  return T_map_start * Pose2{kRadius_m * std::sin(turn_rad),
                             kRadius_m * (1.0 - std::cos(turn_rad)),
                             wrap_to_pi(turn_rad)};
}

Pose2 drive_circle(OdometryModel& odometry, double way_m, int num_steps) {
  Pose2 T_odom_base;
  for (int i = 0; i <= num_steps; ++i) {
    T_odom_base = odometry.move_to(pose_on_circle(way_m * i / num_steps));
  }
  return T_odom_base;
}

TEST(OdometryModel, WithoutDriftItIsTheTruthSeenFromTheStart) {
  OdometryModel odometry(without_drift(), 1);
  const Pose2 expected = pose_on_circle(0.0).inverse() * pose_on_circle(7.0);
  EXPECT_THAT(drive_circle(odometry, 7.0, 50), PoseNear(expected, testing::PoseTolerance{}));
}

TEST(OdometryModel, ScaleErrorsOfARunDoNotDependOnHowFinelyThePathIsSampled) {
  OdometryParams params = without_drift();
  params.distance_scale = 0.1;
  params.turn_scale = 0.1;
  params.turn_bias_rad_per_m = 0.01;
  OdometryModel coarse(params, 5);
  OdometryModel fine(params, 5);
  const Pose2 end = drive_circle(fine, 6.0, 600);
  EXPECT_THAT(drive_circle(coarse, 6.0, 60), PoseNear(end, testing::PoseTolerance{1e-4, 1e-5}));
  const Pose2 truth = pose_on_circle(0.0).inverse() * pose_on_circle(6.0);
  EXPECT_THAT(end, ::testing::Not(PoseNear(truth, testing::PoseTolerance{0.05, 0.01})));
}

TEST(OdometryModel, BackwardsIsNotForwards) {
  OdometryParams params = without_drift();
  params.distance_scale = 0.05;
  OdometryModel odometry(params, 2);
  static_cast<void>(odometry.move_to({}));
  const Pose2 forth = odometry.move_to({1.0, 0.0, 0.0});
  EXPECT_GT(forth.x_m, 0.5);
  EXPECT_THAT(odometry.move_to({}), PoseNear(Pose2{}, testing::PoseTolerance{}));
}

/// Standard deviations of distance and heading after 4 m straight ahead in `num_steps`.
std::pair<double, double> deviations(const OdometryParams& params, int num_steps) {
  constexpr int kNumRuns = 2000;
  double squared_m2 = 0.0;
  double squared_rad2 = 0.0;
  for (int run = 0; run < kNumRuns; ++run) {
    OdometryModel odometry(params, sub_seed(7, run));
    Pose2 end;
    for (int i = 0; i <= num_steps; ++i) end = odometry.move_to({4.0 * i / num_steps, 0.0, 0.0});
    squared_m2 += std::pow(end.x_m - 4.0, 2);
    squared_rad2 += std::pow(end.theta_rad, 2);
  }
  return {std::sqrt(squared_m2 / kNumRuns), std::sqrt(squared_rad2 / kNumRuns)};
}

TEST(OdometryModel, NoiseGrowsWithTheRootOfTheWayHoweverFinelySampled) {
  OdometryParams params = without_drift();
  params.distance_noise_m_per_sqrt_m = 0.01;
  params.turn_noise_rad_per_sqrt_m = 0.0005;
  for (const int num_steps : {1, 10, 100}) {
    const auto [distance_m, heading_rad] = deviations(params, num_steps);
    // Twice a deviation after four times the way; 2000 runs measure it to 5 % at three sigma.
    EXPECT_NEAR(distance_m, 0.02, 0.001) << num_steps;
    EXPECT_NEAR(heading_rad, 0.001, 0.00005) << num_steps;
  }
}

TEST(OdometryModel, TheErrorsOfARunHaveTheStatedDeviations) {
  OdometryParams params = without_drift();
  params.distance_scale = 0.02;
  params.turn_bias_rad_per_m = 0.0001;
  const auto [distance_m, heading_rad] = deviations(params, 8);
  EXPECT_NEAR(distance_m, 0.08, 0.004);
  EXPECT_NEAR(heading_rad, 0.0004, 0.00002);
}

TEST(OdometryModel, TurningOnTheSpotMovesNothing) {
  OdometryModel odometry({}, 3);
  static_cast<void>(odometry.move_to({1.0, 2.0, 0.0}));
  const Pose2 turned = odometry.move_to({1.0, 2.0, 1.5});
  EXPECT_EQ(turned.x_m, 0.0);
  EXPECT_EQ(turned.y_m, 0.0);
  EXPECT_NEAR(turned.theta_rad, 1.5, 0.2);
  EXPECT_NE(turned.theta_rad, 1.5);
}

TEST(OdometryModel, TheSameSeedTheSameRun) {
  OdometryModel one({}, 11);
  OdometryModel two({}, 11);
  OdometryModel other({}, 12);
  const Pose2 end = drive_circle(one, 30.0, 100);
  EXPECT_EQ(end, drive_circle(two, 30.0, 100));
  EXPECT_NE(end, drive_circle(other, 30.0, 100));
}

TEST(OdometryModel, NamesTheBadParameter) {
  OdometryParams params;
  params.turn_scale = -0.1;
  EXPECT_THROW(OdometryModel(params, 1), ParameterError);
  params.turn_scale = std::nan("");
  EXPECT_THROW(OdometryModel(params, 1), ParameterError);
}

}  // namespace setsquare::odometry_model_test
