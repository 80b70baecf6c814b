// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/pose_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "tests/eval/random_trajectory.hpp"

namespace setsquare::pose_pairs_test {

using testing::stamp_at;
using testing::uniform;

/// The plain twin: looks at every pose.
std::optional<std::int64_t> nearest_distance_ns(const Trajectory& trajectory, Timestamp stamp) {
  std::optional<std::int64_t> nearest;
  for (const StampedPose& pose : trajectory) {
    const std::int64_t distance_ns = std::abs(pose.stamp.ns - stamp.ns);
    if (!nearest || distance_ns < *nearest) nearest = distance_ns;
  }
  return nearest;
}

TEST(PoseIndex, FindsWhatLookingAtEveryPoseFinds) {
  auto generator = testing::make_generator();
  for (int run = 0; run < 200; ++run) {
    Trajectory trajectory;
    const int num_poses = static_cast<int>(generator() % 8);
    for (int i = 0; i < num_poses; ++i) {
      trajectory.push_back(
          {Timestamp{static_cast<std::int64_t>(generator() % 50)}, {1.0 * i, 0, 0}});
    }
    const Timestamp wanted{static_cast<std::int64_t>(generator() % 60) - 5};
    const std::int64_t tolerance_ns = static_cast<std::int64_t>(generator() % 10);
    const auto found = PoseIndex(trajectory).find(wanted, tolerance_ns);
    const auto expected_ns = nearest_distance_ns(trajectory, wanted);
    ASSERT_EQ(found.has_value(), expected_ns && *expected_ns <= tolerance_ns);
    if (found) {
      EXPECT_EQ(std::abs(found->stamp.ns - wanted.ns), *expected_ns);
    }
  }
}

TEST(PoseIndex, OfTwoAtOneStampTheFirstAndOfTwoAsNearTheEarlier) {
  const PoseIndex poses({{Timestamp{30}, {3, 0, 0}},
                         {Timestamp{10}, {1, 0, 0}},
                         {Timestamp{10}, {2, 0, 0}},
                         {Timestamp{30}, {4, 0, 0}}});
  EXPECT_EQ(poses.find(Timestamp{10}, 0)->pose.x_m, 1.0);
  EXPECT_EQ(poses.find(Timestamp{12}, 5)->pose.x_m, 1.0);
  EXPECT_EQ(poses.find(Timestamp{20}, 10)->pose.x_m, 1.0);
  EXPECT_EQ(poses.find(Timestamp{29}, 10)->pose.x_m, 3.0);
}

TEST(PosePairs, NearestWithinTheToleranceWhateverTheOrder) {
  const Trajectory trajectory = {
      {stamp_at(2.01), {2, 0, 0}}, {stamp_at(1.0), {1, 0, 0}}, {stamp_at(5.0), {5, 0, 0}}};
  const Trajectory reference = {{stamp_at(4.97), {-5, 0, 0}},
                                {stamp_at(2.03), {-4, 0, 0}},
                                {stamp_at(2.0), {-2, 0, 0}},
                                {stamp_at(1.015), {-1, 0, 0}}};
  const PairedPoses paired = pair_poses(trajectory, reference, 0.02);
  ASSERT_EQ(paired.pairs.size(), 2U);
  EXPECT_EQ(paired.num_unpaired, 1U);
  EXPECT_EQ(paired.pairs[0].T_map_base.x_m, 1.0);
  EXPECT_EQ(paired.pairs[0].T_truth_base.x_m, -1.0);
  EXPECT_EQ(paired.pairs[0].stamp, stamp_at(1.015)) << "the reference's";
  EXPECT_EQ(paired.pairs[1].T_map_base.x_m, 2.0);
  EXPECT_EQ(paired.pairs[1].T_truth_base.x_m, -2.0);
  EXPECT_EQ(pair_poses(trajectory, reference, 0.031).pairs.size(), 3U);
}

}  // namespace setsquare::pose_pairs_test
