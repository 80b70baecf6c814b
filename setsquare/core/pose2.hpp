// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <Eigen/Core>

#include "setsquare/core/angle.hpp"

namespace setsquare {

/// The matrix that turns vectors by an angle, counterclockwise.
[[nodiscard]] inline Eigen::Matrix2d rotation_matrix(double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return (Eigen::Matrix2d() << c, -s, s, c).finished();
}

/// A rigid motion of the plane. Named T_a_b it maps points of frame b into frame a, and is the pose
/// of b in a; in products neighbouring frames cancel: T_a_c = T_a_b * T_b_c.
struct Pose2 {
  double x_m = 0.0;        ///< Of the origin of b along the x axis of a.
  double y_m = 0.0;        ///< The same along its y axis.
  double theta_rad = 0.0;  ///< Products and inverses wrap it to [-pi, pi).

  /// The origin of b in a, in m.
  [[nodiscard]] Eigen::Vector2d translation() const { return {x_m, y_m}; }

  /// T_b_a of a T_a_b: the way back.
  [[nodiscard]] Pose2 inverse() const {
    const double c = std::cos(theta_rad);
    const double s = std::sin(theta_rad);
    return {-(c * x_m + s * y_m), s * x_m - c * y_m, wrap_to_pi(-theta_rad)};
  }

  /// Exactly equal, without a tolerance.
  bool operator==(const Pose2&) const = default;
};

/// T_a_c = T_a_b * T_b_c, its angle in [-pi, pi).
[[nodiscard]] inline Pose2 operator*(const Pose2& T_a_b, const Pose2& T_b_c) {
  const double c = std::cos(T_a_b.theta_rad);
  const double s = std::sin(T_a_b.theta_rad);
  return {T_a_b.x_m + c * T_b_c.x_m - s * T_b_c.y_m,
          T_a_b.y_m + s * T_b_c.x_m + c * T_b_c.y_m,
          wrap_to_pi(T_a_b.theta_rad + T_b_c.theta_rad)};
}

/// A point of frame b, seen from a: p_a = T_a_b * p_b, in m.
[[nodiscard]] inline Eigen::Vector2d operator*(const Pose2& T_a_b, const Eigen::Vector2d& p_b) {
  const double c = std::cos(T_a_b.theta_rad);
  const double s = std::sin(T_a_b.theta_rad);
  return {T_a_b.x_m + c * p_b.x() - s * p_b.y(), T_a_b.y_m + s * p_b.x() + c * p_b.y()};
}

}  // namespace setsquare
