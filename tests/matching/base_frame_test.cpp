// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/base_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/LU>

#include "tests/support/pose_matchers.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::base_frame_test {

using testing::PoseNear;
using testing::PoseTolerance;
using testing::uniform;

Pose2 random_pose(std::mt19937_64& generator, double reach_m) {
  return {uniform(generator, -reach_m, reach_m),
          uniform(generator, -reach_m, reach_m),
          uniform(generator, -kPi, kPi)};
}

MatchResult random_result(std::mt19937_64& generator) {
  MatchResult result;
  result.status = MatchStatus::kDegenerate;
  result.T_reference_current = random_pose(generator, 5.0);
  const Eigen::Matrix3d root = Eigen::Matrix3d::NullaryExpr(
      [&](Eigen::Index, Eigen::Index) { return uniform(generator, -10.0, 10.0); });
  result.information = root * root.transpose();
  result.score = 0.5;
  result.runner_up = RunnerUp{random_pose(generator, 5.0), 0.4};
  result.alias = random_pose(generator, 5.0);
  result.probability = 0.3;
  result.degenerate_direction_rad = uniform(generator, 0.0, kPi);
  return result;
}

TEST(BaseFrame, PosesAreThoseOfTheRobot) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 50; ++trial) {
    const MatchResult of_sensor = random_result(generator);
    const Pose2 T_base_sensor = random_pose(generator, 0.5);
    const Pose2 T_base_sensor_current = random_pose(generator, 0.5);
    const MatchResult of_base =
        match_result_of_base(of_sensor, T_base_sensor, T_base_sensor_current);
    // A point fixed to the current robot, seen both ways from the reference robot.
    for (const Eigen::Vector2d& p_base_current : {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, -2)}) {
      const Eigen::Vector2d p_sensor_current = T_base_sensor_current.inverse() * p_base_current;
      const auto expect_same = [&](const Pose2& T_of_base, const Pose2& T_of_sensor) {
        EXPECT_LT(
            (T_of_base * p_base_current - T_base_sensor * (T_of_sensor * p_sensor_current)).norm(),
            1e-9);
      };
      expect_same(*of_base.T_reference_current, *of_sensor.T_reference_current);
      expect_same(of_base.runner_up->T_reference_current, of_sensor.runner_up->T_reference_current);
    }
    // The answer moved by the alias is the same place in either frame.
    const Pose2 moved_of_base = *of_base.alias * *of_base.T_reference_current;
    const Pose2 moved_of_sensor = *of_sensor.alias * *of_sensor.T_reference_current;
    const Pose2 expected = T_base_sensor * moved_of_sensor * T_base_sensor_current.inverse();
    EXPECT_LT((moved_of_base.translation() - expected.translation()).norm(), 1e-9);
    EXPECT_NEAR(wrap_to_pi(moved_of_base.theta_rad - expected.theta_rad), 0.0, 1e-9);
    EXPECT_EQ(of_base.probability, of_sensor.probability);
    EXPECT_EQ(of_base.status, of_sensor.status);
    EXPECT_EQ(of_base.score, of_sensor.score);
    EXPECT_EQ(of_base.runner_up->score, of_sensor.runner_up->score);
  }
}

TEST(BaseFrame, InformationFollowsTheMappingOfThePoses) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 50; ++trial) {
    const MatchResult of_sensor = random_result(generator);
    const Pose2 T_base_sensor = random_pose(generator, 0.5);
    const Pose2 T_base_sensor_current = random_pose(generator, 0.5);
    const auto pose_of_base = [&](double dx_m, double dy_m, double dtheta_rad) {
      MatchResult moved = of_sensor;
      moved.T_reference_current->x_m += dx_m;
      moved.T_reference_current->y_m += dy_m;
      moved.T_reference_current->theta_rad += dtheta_rad;
      const Pose2 T = T_base_sensor * *moved.T_reference_current * T_base_sensor_current.inverse();
      return T;
    };
    // Column by column: the derivative of the robot's pose by the sensor's.
    Eigen::Matrix3d J;
    constexpr double kStep = 1e-6;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(k);
      const Pose2 plus = pose_of_base(step.x(), step.y(), step.z());
      const Pose2 minus = pose_of_base(-step.x(), -step.y(), -step.z());
      J.col(k) << plus.x_m - minus.x_m, plus.y_m - minus.y_m,
          wrap_to_pi(plus.theta_rad - minus.theta_rad);
    }
    J /= 2.0 * kStep;
    const Eigen::Matrix3d information =
        match_result_of_base(of_sensor, T_base_sensor, T_base_sensor_current).information;
    // The same quadratic form of the same small motion.
    EXPECT_LT((J.transpose() * information * J - of_sensor.information).norm(),
              1e-6 * of_sensor.information.norm());
    EXPECT_LT((information - information.transpose()).norm(), 1e-9 * information.norm());
  }
}

TEST(BaseFrame, TheDegenerateDirectionTurnsWithTheMounting) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 50; ++trial) {
    const MatchResult of_sensor = random_result(generator);
    const Pose2 T_base_sensor = random_pose(generator, 0.5);
    const MatchResult of_base = match_result_of_base(of_sensor, T_base_sensor, T_base_sensor);
    ASSERT_TRUE(of_base.degenerate_direction_rad.has_value());
    EXPECT_GE(*of_base.degenerate_direction_rad, 0.0);
    EXPECT_LT(*of_base.degenerate_direction_rad, kPi);
    EXPECT_NEAR(wrap_to_period(*of_base.degenerate_direction_rad -
                                   *of_sensor.degenerate_direction_rad - T_base_sensor.theta_rad,
                               kPi),
                0.0,
                1e-9);
  }
}

TEST(BaseFrame, WithoutAMountingNothingChanges) {
  auto generator = testing::make_generator();
  const MatchResult of_sensor = random_result(generator);
  const MatchResult of_base = match_result_of_base(of_sensor, {}, {});
  EXPECT_THAT(*of_base.T_reference_current,
              PoseNear(*of_sensor.T_reference_current, PoseTolerance{}));
  EXPECT_LT((of_base.information - of_sensor.information).norm(), 1e-9);
}

TEST(BaseFrame, WhatIsAbsentStaysAbsent) {
  const MatchResult nothing = match_result_of_base({}, {0.1, 0.2, 0.3}, {0.1, 0.2, 0.3});
  EXPECT_FALSE(nothing.T_reference_current.has_value());
  EXPECT_FALSE(nothing.runner_up.has_value());
  EXPECT_FALSE(nothing.degenerate_direction_rad.has_value());
}

}  // namespace setsquare::base_frame_test
