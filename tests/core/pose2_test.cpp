// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/pose2.hpp"

#include <gtest/gtest.h>

#include "tests/support/pose_matchers.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::pose2_test {

using testing::PoseNear;
using testing::PoseTolerance;

constexpr PoseTolerance kExact{.translation_m = 1e-12, .rotation_rad = 1e-12};

Pose2 random_pose(std::mt19937_64& generator) {
  return {testing::uniform(generator, -10.0, 10.0),
          testing::uniform(generator, -10.0, 10.0),
          testing::uniform(generator, -kPi, kPi)};
}

TEST(Pose2, MapsPointsOfTheSecondFrameIntoTheFirst) {
  const Pose2 T_map_base{1.0, 2.0, 0.5 * kPi};
  const Eigen::Vector2d p_map = T_map_base * Eigen::Vector2d(3.0, 0.0);
  EXPECT_NEAR(p_map.x(), 1.0, 1e-15);
  EXPECT_NEAR(p_map.y(), 5.0, 1e-15);
}

TEST(Pose2, ObeysTheLawsOfAGroup) {
  std::mt19937_64 generator = testing::make_generator();
  for (int i = 0; i < 100; ++i) {
    const Pose2 T_a_b = random_pose(generator);
    const Pose2 T_b_c = random_pose(generator);
    const Pose2 T_c_d = random_pose(generator);
    EXPECT_THAT(T_a_b * T_a_b.inverse(), PoseNear(Pose2{}, kExact));
    EXPECT_THAT(T_a_b.inverse() * T_a_b, PoseNear(Pose2{}, kExact));
    EXPECT_THAT((T_a_b * T_b_c) * T_c_d, PoseNear(T_a_b * (T_b_c * T_c_d), kExact));
    EXPECT_THAT(T_a_b * Pose2{}, PoseNear(T_a_b, kExact));
    const Eigen::Vector2d p_c(1.0, -2.0);
    EXPECT_NEAR(((T_a_b * T_b_c) * p_c - T_a_b * (T_b_c * p_c)).norm(), 0.0, 1e-12);
  }
}

TEST(Pose2, ProductsAndInversesWrapTheHeading) {
  const Pose2 T_a_b{0.0, 0.0, 3.0};
  EXPECT_NEAR((T_a_b * T_a_b).theta_rad, 6.0 - kTwoPi, 1e-15);
  EXPECT_EQ(Pose2({0.0, 0.0, -kPi}).inverse().theta_rad, -kPi);
}

}  // namespace setsquare::pose2_test
