// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "setsquare/core/trajectory.hpp"

namespace setsquare {
/// Stamps of one scan in two files differ by their rounding, in ns: relations and trajectories keep
/// five or six decimals of a second.
inline constexpr std::int64_t kSameStamp_ns = 12'000;

/// The poses of a trajectory by their stamps; the trajectory's order does not matter.
class PoseIndex {
 public:
  /// Sorts a copy of the poses by their stamps.
  explicit PoseIndex(const Trajectory& trajectory);

  /// The pose nearest in time, at most `tolerance_ns` away; of two equally near the earlier, of two
  /// at one stamp the first in the trajectory. Nothing where there is none.
  [[nodiscard]] std::optional<StampedPose> find(Timestamp stamp,
                                                std::int64_t tolerance_ns = kSameStamp_ns) const;

  /// All poses, earliest first.
  [[nodiscard]] std::span<const StampedPose> poses() const { return poses_; }

 private:
  Trajectory poses_;
};

/// The same moment in two trajectories: in the frame `map` of the one that is judged and in the
/// frame `truth` of its reference.
struct PosePair {
  Timestamp stamp;     ///< The reference's.
  Pose2 T_map_base;    ///< By the trajectory that is judged.
  Pose2 T_truth_base;  ///< By its reference.
};

/// Two trajectories, moment by moment.
struct PairedPoses {
  std::vector<PosePair> pairs;   ///< Earliest first.
  std::size_t num_unpaired = 0;  ///< Poses of the trajectory without one of the reference.
};

/// Gives each pose of a trajectory the pose of the reference nearest in time, at most
/// `max_time_difference_s` (s, not negative) away. The order of either does not matter.
[[nodiscard]] PairedPoses pair_poses(const Trajectory& trajectory,
                                     const Trajectory& reference,
                                     double max_time_difference_s);

}  // namespace setsquare
