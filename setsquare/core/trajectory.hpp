// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"

namespace setsquare {

/// Where something was at one moment.
struct StampedPose {
  Timestamp stamp;  ///< When it was there.
  Pose2 pose;       ///< In the trajectory's frame; whose pose, `base` or `sensor`, its maker says.
};

/// Stamped poses in the order in which they were measured (file order). Stamps may run backwards:
/// real logs do.
using Trajectory = std::vector<StampedPose>;

}  // namespace setsquare
