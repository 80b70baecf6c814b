// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "setsquare/eval/pose_pairs.hpp"

namespace setsquare {

/// T_truth_map that lays the positions of a trajectory onto their reference with the least sum of
/// squared distances: Umeyama 1991 in the plane, without scale. Where positions do not tell the
/// rotation (the robot stood still, or there is one pose only) the mean difference of the headings
/// does. The identity for no pair.
[[nodiscard]] Pose2 best_rigid_alignment(std::span<const PosePair> pairs);

}  // namespace setsquare
