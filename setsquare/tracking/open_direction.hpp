// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace setsquare {

/// The direction along which a scan's walls determine the position least.
struct OpenDirection {
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< Unit vector.
  /// How many points bind the position along it, if each faced it squarely: the smaller eigenvalue
  /// of the sum of the weighted outer products of the normals. A bare corridor shows less than one.
  double effective_points = 0.0;
};

/// The smaller eigenvalue and its eigenvector of a symmetric 2 x 2 matrix (points).
[[nodiscard]] OpenDirection open_direction(const Eigen::Matrix2d& information_points);

/// Keeps this share, 0 to 1, of what binds the open direction: P of P H P and P g, for normal
/// equations in (x, y, theta). Walls that run along it bind it all the same, by the noise of their
/// normals, and they would hold it where it is.
[[nodiscard]] Eigen::Matrix3d keeping_open_share(const OpenDirection& open, double share);

}  // namespace setsquare
