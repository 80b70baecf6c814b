// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"

namespace setsquare {

/// One line of ground truth (Kuemmerle et al. 2009): where the robot was at `current_stamp`, seen
/// from where it was at `reference_stamp`. Poses are those of `base`.
struct Relation {
  Timestamp reference_stamp;  ///< Of the pose from which the other is seen.
  Timestamp current_stamp;    ///< Of the pose that is seen.
  Pose2 T_reference_current;  ///< The true pose of `base` at the second stamp in that of the first.
};

}  // namespace setsquare
