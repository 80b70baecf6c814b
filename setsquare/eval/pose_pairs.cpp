// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/pose_pairs.hpp"

#include <cmath>
#include <cstdint>

#include "setsquare/eval/pose_index.hpp"

namespace setsquare {

PairedPoses pair_poses(const Trajectory& trajectory,
                       const Trajectory& reference,
                       double max_time_difference_s) {
  const PoseIndex in_order(trajectory);
  const PoseIndex truth(reference);
  const auto tolerance_ns = static_cast<std::int64_t>(std::llround(1e9 * max_time_difference_s));
  PairedPoses paired;
  for (const StampedPose& judged : in_order.poses()) {
    const auto true_pose = truth.find(judged.stamp, tolerance_ns);
    if (true_pose) {
      paired.pairs.push_back({true_pose->stamp, judged.pose, true_pose->pose});
    } else {
      ++paired.num_unpaired;
    }
  }
  return paired;
}

}  // namespace setsquare
