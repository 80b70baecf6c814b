// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

namespace setsquare {

/// Half a turn, in rad.
inline constexpr double kPi = std::numbers::pi;
/// A whole turn, in rad.
inline constexpr double kTwoPi = 2.0 * std::numbers::pi;
/// A quarter of a turn, in rad: walls repeat after it.
inline constexpr double kQuarterTurn = 0.5 * kPi;

/// Radians of an angle in degrees.
[[nodiscard]] constexpr double rad_from_deg(double angle_deg) { return angle_deg * (kPi / 180.0); }
/// Degrees of an angle in radians.
[[nodiscard]] constexpr double deg_from_rad(double angle_rad) { return angle_rad * (180.0 / kPi); }

/// The angle's equal in [-period/2, period/2), in rad. The period is positive.
[[nodiscard]] inline double wrap_to_period(double angle_rad, double period_rad) {
  const double wrapped = angle_rad - period_rad * std::floor(angle_rad / period_rad + 0.5);
  return wrapped >= 0.5 * period_rad ? wrapped - period_rad : wrapped;
}

/// The angle's equal in [-pi, pi), in rad.
[[nodiscard]] inline double wrap_to_pi(double angle_rad) {
  return wrap_to_period(angle_rad, kTwoPi);
}

}  // namespace setsquare
