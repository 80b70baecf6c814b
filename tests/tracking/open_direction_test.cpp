// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/open_direction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "setsquare/core/symmetric_eigen.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::open_direction_test {

using testing::make_generator;
using testing::uniform;

TEST(OpenDirection, EqualsTheEigensolver) {
  auto generator = make_generator();
  for (int trial = 0; trial < 200; ++trial) {
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    for (int wall = 0; wall < 3; ++wall) {
      const double angle_rad = uniform(generator, -3.0, 3.0);
      const Eigen::Vector2d normal(std::cos(angle_rad), std::sin(angle_rad));
      information += uniform(generator, 0.0, 50.0) * normal * normal.transpose();
    }
    const SymmetricEigen<2> twin = symmetric_eigen(information);
    const OpenDirection open = open_direction(information);
    EXPECT_NEAR(open.effective_points, twin.values(0), 1e-9);
    EXPECT_NEAR(std::abs(open.direction.dot(twin.vectors.col(0))), 1.0, 1e-6);
  }
}

TEST(OpenDirection, OneWallLeavesItsOwnDirectionFree) {
  const Eigen::Vector2d normal(0.6, 0.8);
  const OpenDirection open = open_direction(70.0 * normal * normal.transpose());
  EXPECT_NEAR(open.effective_points, 0.0, 1e-9);
  EXPECT_NEAR(open.direction.dot(normal), 0.0, 1e-12);
}

}  // namespace setsquare::open_direction_test
