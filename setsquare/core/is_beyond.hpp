// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// Whether a motion goes farther than `way_m` or turns more than `turn_rad`.
[[nodiscard]] inline bool is_beyond(const Pose2& motion, double way_m, double turn_rad) {
  return std::hypot(motion.x_m, motion.y_m) > way_m || std::abs(motion.theta_rad) > turn_rad;
}

}  // namespace setsquare
