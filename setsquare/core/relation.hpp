// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"

namespace setsquare {

/// One line of ground truth (Kuemmerle et al. 2009): where the robot was at `current_stamp`, seen
/// from where it was at `reference_stamp`. Poses are those of `base`.
struct Relation {
  Timestamp reference_stamp;
  Timestamp current_stamp;
  Pose2 T_reference_current;
};

}  // namespace setsquare
