// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace setsquare {

/// A corner chain in the map frame, in m.
using Corners = std::vector<Eigen::Vector2d>;

/// Part of an ellipse: center + cos(t) first_axis + sin(t) second_axis, t from start_rad on by
/// sweep_rad. The axes need not be perpendicular (an ellipse under an affine map).
struct EllipseArc {
  Eigen::Vector2d center_m;
  Eigen::Vector2d first_axis_m;
  Eigen::Vector2d second_axis_m;
  double start_rad = 0.0;
  double sweep_rad = 0.0;
};

/// Appends corners along a curve, its first point excluded, so that no chord is farther than
/// `tolerance_m` from it. (A chord over a step h of the parameter is off by at most h^2 / 8 times
/// the largest second derivative.) At most 4096 chords.
void append_arc(Corners& corners, const EllipseArc& arc, double tolerance_m);

/// Bezier curves that begin at the last corner; `corners` must not be empty.
void append_quadratic(Corners& corners,
                      const Eigen::Vector2d& control_m,
                      const Eigen::Vector2d& end_m,
                      double tolerance_m);
void append_cubic(Corners& corners,
                  const Eigen::Vector2d& first_control_m,
                  const Eigen::Vector2d& second_control_m,
                  const Eigen::Vector2d& end_m,
                  double tolerance_m);

}  // namespace setsquare
