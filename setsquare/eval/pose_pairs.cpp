// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/pose_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace setsquare {
namespace {

bool is_earlier(const StampedPose& a, const StampedPose& b) { return a.stamp < b.stamp; }

}  // namespace

PoseIndex::PoseIndex(const Trajectory& trajectory) : poses_(trajectory) {
  std::stable_sort(poses_.begin(), poses_.end(), is_earlier);
}

std::optional<StampedPose> PoseIndex::find(Timestamp stamp, std::int64_t tolerance_ns) const {
  const auto first_at = [this](Timestamp wanted) {
    return std::lower_bound(poses_.begin(), poses_.end(), StampedPose{wanted, {}}, is_earlier);
  };
  const auto after = first_at(stamp);
  std::optional<StampedPose> nearest;
  if (after != poses_.begin()) {
    const auto before = first_at((after - 1)->stamp);
    if (stamp.ns - before->stamp.ns <= tolerance_ns) nearest = *before;
  }
  if (after == poses_.end() || after->stamp.ns - stamp.ns > tolerance_ns) return nearest;
  if (nearest && stamp.ns - nearest->stamp.ns <= after->stamp.ns - stamp.ns) return nearest;
  return *after;
}

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
