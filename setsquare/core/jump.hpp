// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// Whether no robot that carries a laser scanner through a building moves like this: a step of more
/// than 0.5 m or 30 degrees, faster than 5 m/s or 600 degrees per second.
[[nodiscard]] inline bool is_jump(const Pose2& T_before_after, double seconds) {
  constexpr double kLongStep_m = 0.5;
  constexpr double kFastest_m_per_s = 5.0;
  constexpr double kLargestTurn_rad = rad_from_deg(30.0);
  constexpr double kFastest_rad_per_s = rad_from_deg(600.0);
  const double distance_m = std::hypot(T_before_after.x_m, T_before_after.y_m);
  const double turn_rad = std::abs(T_before_after.theta_rad);
  return (distance_m > kLongStep_m && distance_m > kFastest_m_per_s * seconds) ||
         (turn_rad > kLargestTurn_rad && turn_rad > kFastest_rad_per_s * seconds);
}

}  // namespace setsquare
