// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/core/trajectory.hpp"

namespace setsquare {

/// The same moment in two trajectories: in the frame `map` of the one that is judged and in the
/// frame `truth` of its reference.
struct PosePair {
  Timestamp stamp;  ///< The reference's.
  Pose2 T_map_base;
  Pose2 T_truth_base;
};

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
