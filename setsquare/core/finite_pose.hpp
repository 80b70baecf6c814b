// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "setsquare/core/error.hpp"
#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// Throws ParameterError with the name where a part of the pose is infinite or NaN.
inline void require_finite_pose(const Pose2& pose, const char* name) {
  if (std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.theta_rad)) return;
  throw ParameterError(name, "must be finite");
}

}  // namespace setsquare
