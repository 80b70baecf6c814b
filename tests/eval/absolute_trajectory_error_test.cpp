// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/absolute_trajectory_error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/eval/random_trajectory.hpp"
#include "tests/support/pose_matchers.hpp"

namespace setsquare::absolute_trajectory_error_test {

using testing::moved;
using testing::PoseNear;
using testing::random_pose;
using testing::random_trajectory;
using testing::stamp_at;

std::vector<PosePair> pairs_of(const Trajectory& trajectory, const Trajectory& reference) {
  return pair_poses(trajectory, reference, 0.0).pairs;
}

/// A trajectory and a noisy copy of it in another frame.
std::vector<PosePair> noisy_pairs(std::mt19937_64& generator) {
  const Trajectory truth = random_trajectory(generator, 60);
  Trajectory judged = moved(truth, random_pose(generator));
  for (StampedPose& stamped : judged) {
    stamped.pose = stamped.pose * testing::small_motion(generator, 0.5, 0.1);
  }
  return pairs_of(judged, truth);
}

double sum_of_squares_m2(std::span<const PosePair> pairs, const Pose2& T_truth_map) {
  double sum = 0.0;
  for (const PosePair& pair : pairs) {
    sum += (T_truth_map * pair.T_map_base.translation() - pair.T_truth_base.translation())
               .squaredNorm();
  }
  return sum;
}

TEST(ErrorStatistics, ByHand) {
  const ErrorStatistics even = error_statistics(std::vector<double>{10.0, 1.0, 3.0, 2.0});
  EXPECT_EQ(even.num_values, 4U);
  EXPECT_DOUBLE_EQ(even.mean, 4.0);
  EXPECT_DOUBLE_EQ(even.rmse, std::sqrt(114.0 / 4.0));
  EXPECT_DOUBLE_EQ(even.median, 2.5);
  EXPECT_DOUBLE_EQ(even.max, 10.0);
  EXPECT_DOUBLE_EQ(even.deviation, std::sqrt((36.0 + 9.0 + 1.0 + 4.0) / 4.0));
  EXPECT_DOUBLE_EQ(error_statistics(std::vector<double>{5.0, 1.0, 2.0}).median, 2.0);
  EXPECT_EQ(error_statistics({}).num_values, 0U);
}

TEST(RigidAlignment, UndoesARigidMotion) {
  auto generator = testing::make_generator();
  for (int run = 0; run < 20; ++run) {
    const Trajectory truth = random_trajectory(generator, 30);
    const Pose2 T_map_truth = random_pose(generator);
    EXPECT_THAT(best_rigid_alignment(pairs_of(moved(truth, T_map_truth), truth)),
                PoseNear(T_map_truth.inverse(), testing::PoseTolerance{}));
  }
}

// The plain twin: every tenth of a degree, with the means laid onto each other.
TEST(RigidAlignment, NoOtherMotionHasLessSquaredDistance) {
  auto generator = testing::make_generator();
  const std::vector<PosePair> pairs = noisy_pairs(generator);
  const double least_m2 = sum_of_squares_m2(pairs, best_rigid_alignment(pairs));
  EXPECT_GT(least_m2, 1.0) << "there is noise";
  Eigen::Vector2d mean_map = Eigen::Vector2d::Zero();
  Eigen::Vector2d mean_truth = Eigen::Vector2d::Zero();
  for (const PosePair& pair : pairs) {
    mean_map += pair.T_map_base.translation() / static_cast<double>(pairs.size());
    mean_truth += pair.T_truth_base.translation() / static_cast<double>(pairs.size());
  }
  double least_of_twin_m2 = 1e9;
  for (int tenth_deg = 0; tenth_deg < 3600; ++tenth_deg) {
    Pose2 T_truth_map{0.0, 0.0, rad_from_deg(0.1 * tenth_deg)};
    const Eigen::Vector2d shift = mean_truth - T_truth_map * mean_map;
    T_truth_map.x_m = shift.x();
    T_truth_map.y_m = shift.y();
    const double sum_m2 = sum_of_squares_m2(pairs, T_truth_map);
    EXPECT_GE(sum_m2, least_m2);
    least_of_twin_m2 = std::min(least_of_twin_m2, sum_m2);
  }
  EXPECT_LT(least_of_twin_m2, 1.01 * least_m2);
}

TEST(RigidAlignment, AtAStandstillTheHeadingsDetermineTheRotation) {
  const std::vector<PosePair> pairs = {{stamp_at(0.0), {1, 2, 0.1}, {5, 5, 0.4}},
                                       {stamp_at(1.0), {1, 2, 0.2}, {5, 5, 0.5}}};
  const Pose2 T_truth_map = best_rigid_alignment(pairs);
  EXPECT_NEAR(T_truth_map.theta_rad, 0.3, 1e-12);
  EXPECT_THAT(T_truth_map * Pose2({1, 2, 0.1}),
              PoseNear(Pose2{5, 5, 0.4}, testing::PoseTolerance{}));
  EXPECT_EQ(best_rigid_alignment({}), Pose2{});
}

// A straight way of three poses; the judged one's middle is 0.3 m aside: the line of least squares
// runs 0.1 m aside of the two others.
TEST(AbsoluteTrajectoryError, ByHand) {
  const Trajectory truth = {
      {stamp_at(0), {0, 0, 0}}, {stamp_at(1), {1, 0, 0}}, {stamp_at(2), {2, 0, 0}}};
  const Trajectory judged = {
      {stamp_at(2), {2, 0, 0.2}}, {stamp_at(0), {0, 0, 0}}, {stamp_at(1), {1, 0.3, -0.1}}};
  const auto pairs = pairs_of(judged, truth);
  const auto best = absolute_trajectory_error(pairs, TrajectoryAlignment::kBest);
  EXPECT_THAT(best.T_truth_map, PoseNear(Pose2{0, -0.1, 0}, testing::PoseTolerance{}));
  EXPECT_NEAR(best.translation_m.mean, (0.1 + 0.2 + 0.1) / 3.0, 1e-12);
  EXPECT_NEAR(best.translation_m.max, 0.2, 1e-12);
  EXPECT_NEAR(best.rotation_rad.mean, 0.1, 1e-12);
  EXPECT_NEAR(best.final_translation_m, 0.1, 1e-12);
  EXPECT_NEAR(best.final_rotation_rad, 0.2, 1e-12);
  const auto none = absolute_trajectory_error(pairs, TrajectoryAlignment::kNone);
  EXPECT_EQ(none.T_truth_map, Pose2{});
  EXPECT_NEAR(none.translation_m.median, 0.0, 1e-12);
  EXPECT_NEAR(none.translation_m.rmse, 0.3 / std::sqrt(3.0), 1e-12);
}

TEST(AbsoluteTrajectoryError, TheFirstPosesAgreeWhereItIsAsked) {
  auto generator = testing::make_generator();
  const auto pairs = noisy_pairs(generator);
  const auto first = absolute_trajectory_error(pairs, TrajectoryAlignment::kFirst);
  EXPECT_THAT(first.T_truth_map * pairs.front().T_map_base,
              PoseNear(pairs.front().T_truth_base, testing::PoseTolerance{}));
  EXPECT_GT(first.translation_m.rmse,
            absolute_trajectory_error(pairs, TrajectoryAlignment::kBest).translation_m.rmse);
}

TEST(AbsoluteTrajectoryError, NoneAgainstItself) {
  auto generator = testing::make_generator();
  const Trajectory trajectory = random_trajectory(generator, 40);
  for (const auto alignment :
       {TrajectoryAlignment::kBest, TrajectoryAlignment::kFirst, TrajectoryAlignment::kNone}) {
    const auto error = absolute_trajectory_error(pairs_of(trajectory, trajectory), alignment);
    EXPECT_LT(error.translation_m.max, 1e-12);
    EXPECT_LT(error.rotation_rad.max, 1e-12);
  }
}

TEST(AbsoluteTrajectoryError, ARigidMotionOfEitherChangesNothing) {
  auto generator = testing::make_generator();
  const auto pairs = noisy_pairs(generator);
  const Pose2 T_a = random_pose(generator);
  const Pose2 T_b = random_pose(generator);
  auto both_moved = pairs;
  for (PosePair& pair : both_moved) {
    pair.T_map_base = T_a * pair.T_map_base;
    pair.T_truth_base = T_b * pair.T_truth_base;
  }
  for (const auto alignment : {TrajectoryAlignment::kBest, TrajectoryAlignment::kFirst}) {
    const auto before = absolute_trajectory_error(pairs, alignment);
    const auto after = absolute_trajectory_error(both_moved, alignment);
    EXPECT_NEAR(before.translation_m.rmse, after.translation_m.rmse, 1e-9);
    EXPECT_NEAR(before.translation_m.median, after.translation_m.median, 1e-9);
    EXPECT_NEAR(before.rotation_rad.mean, after.rotation_rad.mean, 1e-9);
  }
}

}  // namespace setsquare::absolute_trajectory_error_test
