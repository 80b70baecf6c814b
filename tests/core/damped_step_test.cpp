// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/damped_step.hpp"

#include <gtest/gtest.h>

namespace setsquare::damped_step_test {

/// Equations whose third direction nothing determines.
NormalEquations<3> open_equations() {
  NormalEquations<3> data;
  data.hessian.diagonal() << 4.0, 2.0, 0.0;
  data.gradient << 8.0, -2.0, 0.0;
  return data;
}

TEST(DampedStep, SolvesTheEquationsAndStaysAlongAnOpenDirection) {
  const Eigen::Vector3d step = damped_step(open_equations(), 1e-9);
  EXPECT_NEAR(step.x(), -2.0, 1e-6);
  EXPECT_NEAR(step.y(), 1.0, 1e-6);
  EXPECT_EQ(step.z(), 0.0);
}

TEST(DampedStep, DampingShortensTheStep) {
  const Eigen::Vector3d step = damped_step(open_equations(), 4.0);
  EXPECT_NEAR(step.x(), -1.0, 1e-12);
  EXPECT_NEAR(step.y(), 1.0 / 3.0, 1e-12);
}

TEST(DampedStep, PriorDecidesWhereTheDataDoNot) {
  NormalEquations<3> prior;
  prior.hessian(2, 2) = 10.0;
  prior.gradient(2) = 5.0;
  EXPECT_NEAR(damped_step(open_equations(), 1e-9, prior).z(), -0.5, 1e-6);
}

TEST(DampedStep, EachDirectionCanHaveItsOwnDamping) {
  const Eigen::Vector3d step = damped_step<3>(open_equations(), {4.0, 0.0, 1.0});
  EXPECT_NEAR(step.x(), -1.0, 1e-12);
  EXPECT_NEAR(step.y(), 1.0, 1e-12);
}

TEST(DampedStep, QuickOneIsTheSame) {
  NormalEquations<3> data;
  data.hessian << 5.0, 1.0, -2.0, 1.0, 4.0, 0.5, -2.0, 0.5, 9.0;
  data.gradient << 1.0, -2.0, 3.0;
  EXPECT_LT((quick_damped_step(data, 0.1) - damped_step(data, 0.1)).norm(), 1e-12);
}

TEST(DampedStep, StepMovesThePose) {
  const Pose2 moved = stepped({1.0, 2.0, 3.0}, {0.5, -0.5, 0.5});
  EXPECT_DOUBLE_EQ(moved.x_m, 1.5);
  EXPECT_DOUBLE_EQ(moved.y_m, 1.5);
  EXPECT_NEAR(moved.theta_rad, 3.5 - kTwoPi, 1e-12);
}

}  // namespace setsquare::damped_step_test
