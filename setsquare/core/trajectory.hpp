// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"

namespace setsquare {

struct StampedPose {
  Timestamp stamp;
  Pose2 pose;
};

/// Stamped poses in the order in which they were measured (file order). Stamps may run backwards:
/// real logs do.
using Trajectory = std::vector<StampedPose>;

}  // namespace setsquare
