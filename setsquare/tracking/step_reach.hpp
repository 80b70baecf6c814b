// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// How far a step from scan to scan goes, or may go.
struct StepReach {
  double distance_m = 0.0;  ///< As the crow flies.
  double turn_rad = 0.0;    ///< Not negative.
};

/// Of a motion.
[[nodiscard]] inline StepReach reach_of(const Pose2& motion) {
  return {std::hypot(motion.x_m, motion.y_m), std::abs(motion.theta_rad)};
}

}  // namespace setsquare
