// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/relative_trajectory_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "setsquare/core/error.hpp"
#include "tests/eval/random_trajectory.hpp"

namespace setsquare::relative_trajectory_error_test {

using testing::random_pose;
using testing::stamp_at;

/// A straight way of 0.5 m per second. The judged one stretches it by a tenth.
std::vector<PosePair> stretched_way(int num_poses) {
  std::vector<PosePair> pairs;
  for (int i = 0; i < num_poses; ++i) {
    pairs.push_back({stamp_at(i), {0.55 * i, 0.0, 0.0}, {0.5 * i, 0.0, 0.0}});
  }
  return pairs;
}

TEST(RelativeTrajectoryError, OfAWayStretchedByATenth) {
  const auto pairs = stretched_way(10);
  const auto over_1_m = relative_trajectory_error(pairs);
  EXPECT_EQ(over_1_m.translation_m.num_values, 8U);
  EXPECT_NEAR(over_1_m.translation_m.mean, 0.1, 1e-12);
  EXPECT_NEAR(over_1_m.translation_m.deviation, 0.0, 1e-12);
  EXPECT_EQ(over_1_m.rotation_rad.max, 0.0);
  const auto over_3_s = relative_trajectory_error(pairs, {RelativeSpan::kTime, 3.0});
  EXPECT_EQ(over_3_s.translation_m.num_values, 7U);
  EXPECT_NEAR(over_3_s.translation_m.mean, 0.15, 1e-12);
  const auto over_5_poses = relative_trajectory_error(pairs, {RelativeSpan::kPoses, 5.0});
  EXPECT_EQ(over_5_poses.translation_m.num_values, 5U);
  EXPECT_NEAR(over_5_poses.translation_m.mean, 0.25, 1e-12);
  EXPECT_EQ(relative_trajectory_error(pairs, {RelativeSpan::kTime, 9.5}).translation_m.num_values,
            0U);
}

// E = (T_truth_i^-1 T_truth_j)^-1 (T_map_i^-1 T_map_j): the judged robot drives 1.2 m ahead and
// turns by 0.1 rad, the true one turns by 90 deg on its way.
TEST(RelativeTrajectoryError, ByHand) {
  const std::vector<PosePair> pairs = {{stamp_at(0), {3, 4, kPi / 2}, {0, 0, 0}},
                                       {stamp_at(1), {3, 5.2, kPi / 2 + 0.1}, {1, 0, kPi / 2}}};
  const auto error = relative_trajectory_error(pairs);
  ASSERT_EQ(error.translation_m.num_values, 1U);
  EXPECT_NEAR(error.translation_m.mean, 0.2, 1e-12);
  EXPECT_NEAR(error.rotation_rad.mean, kPi / 2 - 0.1, 1e-12);
}

TEST(RelativeTrajectoryError, AJumpIsFeltOnlyAcrossIt) {
  auto pairs = stretched_way(20);
  for (int i = 0; i < 20; ++i) pairs[i].T_map_base = pairs[i].T_truth_base;
  for (int i = 10; i < 20; ++i) pairs[i].T_map_base.x_m += 2.0;
  const auto error = relative_trajectory_error(pairs);
  EXPECT_EQ(error.translation_m.num_values, 18U);
  EXPECT_NEAR(error.translation_m.mean, 2 * 2.0 / 18, 1e-12);
  EXPECT_NEAR(error.translation_m.max, 2.0, 1e-12);
}

TEST(RelativeTrajectoryError, ARigidMotionOfEitherChangesNothing) {
  auto generator = testing::make_generator();
  std::vector<PosePair> pairs = stretched_way(30);
  for (PosePair& pair : pairs) {
    pair.T_map_base = pair.T_map_base * testing::small_motion(generator, 0.1, 0.1);
  }
  auto both_moved = pairs;
  const Pose2 T_a = random_pose(generator);
  const Pose2 T_b = random_pose(generator);
  for (PosePair& pair : both_moved) {
    pair.T_map_base = T_a * pair.T_map_base;
    pair.T_truth_base = T_b * pair.T_truth_base;
  }
  const auto before = relative_trajectory_error(pairs);
  const auto after = relative_trajectory_error(both_moved);
  EXPECT_GT(before.translation_m.rmse, 0.01);
  EXPECT_NEAR(before.translation_m.rmse, after.translation_m.rmse, 1e-9);
  EXPECT_NEAR(before.rotation_rad.median, after.rotation_rad.median, 1e-9);
}

TEST(RelativeTrajectoryError, SpansOverAGapAreLeftOut) {
  auto pairs = stretched_way(20);
  pairs.erase(pairs.begin() + 8, pairs.begin() + 14);
  const auto error = relative_trajectory_error(pairs);
  EXPECT_EQ(error.num_left_out, 2U);
  EXPECT_EQ(error.translation_m.num_values, 10U);
  EXPECT_NEAR(error.translation_m.max, 0.1, 1e-12);
}

TEST(RelativeTrajectoryError, ALengthMustBePositive) {
  const auto pairs = stretched_way(3);
  for (const double length : {0.0, -1.0, std::nan("")}) {
    EXPECT_THROW(static_cast<void>(relative_trajectory_error(pairs, {RelativeSpan::kTime, length})),
                 ParameterError);
  }
}

}  // namespace setsquare::relative_trajectory_error_test
