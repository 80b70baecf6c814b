// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/damped_step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Cholesky>

#include "tests/support/seed.hpp"

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

/// Of any scale in each direction, and now and then without a hold along one.
template <int kSize>
NormalEquations<kSize> random_equations(std::mt19937_64& generator) {
  using Square = Eigen::Matrix<double, kSize, kSize>;
  using Column = Eigen::Matrix<double, kSize, 1>;
  const Square jacobian =
      Square::NullaryExpr([&generator] { return testing::uniform(generator, -1.0, 1.0); });
  Column scale = Column::NullaryExpr(
      [&generator] { return std::pow(10.0, testing::uniform(generator, -6.0, 6.0)); });
  if (testing::uniform(generator, 0.0, 1.0) < 0.2) scale[kSize - 1] = 0.0;
  NormalEquations<kSize> equations;
  equations.hessian = scale.asDiagonal() * (jacobian.transpose() * jacobian) * scale.asDiagonal();
  equations.gradient = scale.asDiagonal() * jacobian.transpose() * Column::Ones();
  return equations;
}

template <int kSize>
void expect_the_step_of_eigens_ldlt() {
  std::mt19937_64 generator = testing::make_generator();
  for (int k = 0; k < 20000; ++k) {
    const NormalEquations<kSize> data = random_equations<kSize>(generator);
    const NormalEquations<kSize> prior = random_equations<kSize>(generator);
    const double damping = k % 2 == 0 ? 1e-3 : 0.0;
    const bool has_prior = k % 3 == 0;
    const auto step = damped_step<kSize>(data,
                                         Eigen::Matrix<double, kSize, 1>::Constant(damping),
                                         has_prior ? prior : NormalEquations<kSize>{});
    Eigen::Matrix<double, kSize, kSize> hessian = data.hessian;
    hessian.diagonal().array() += damping;
    Eigen::Matrix<double, kSize, 1> gradient = data.gradient;
    if (has_prior) {
      hessian += prior.hessian;
      gradient += prior.gradient;
    }
    const Eigen::Matrix<double, kSize, 1> expected = hessian.ldlt().solve(-gradient);
    // To the last bit: maps stay as they were.
    ASSERT_TRUE(step == expected) << step << "\n" << expected << "\n" << testing::test_seed();
  }
}

TEST(DampedStep, IsThatOfEigensDecomposition) {
  expect_the_step_of_eigens_ldlt<3>();
  expect_the_step_of_eigens_ldlt<5>();
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
