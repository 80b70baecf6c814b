// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/matching/surface_points.hpp"
#include "setsquare/slam/keyframe.hpp"

namespace setsquare {

/// How point-to-line distances count.
struct AlignmentScale {
  double gate_m = 0.15;   ///< Farther points have no part.
  double scale_m = 0.05;  ///< Distance at which a point's weight has fallen to 1/4 (Geman-McClure).
};

/// A scan against a submap at one pose: what agrees, and the normal equations of the point-to-line
/// distances in (x, y, theta) of T_odom_sensor, summed over the keyframes and divided by the number
/// of keyframes that saw a point's surroundings: a point counts once, however often it was seen.
struct SubmapAlignment {
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();   ///< points x (1, m, m^2)
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< points x m x (1, m)
  double num_compared = 0.0;      ///< Points that fall where some keyframe saw a surface.
  double num_explained = 0.0;     ///< Of these, on the surface of some keyframe.
  double num_contradicted = 0.0;  ///< Of these, on none and where some keyframe saw through.

  [[nodiscard]] double explained() const {
    return num_compared > 0.0 ? num_explained / num_compared : 0.0;
  }
  /// Share explained less share contradicted, -1 to 1.
  [[nodiscard]] double score() const {
    return num_compared > 0.0 ? (num_explained - num_contradicted) / num_compared : -1.0;
  }
};

/// Reused between calls; holds what each point met.
using PointMarks = std::vector<std::uint8_t>;

[[nodiscard]] SubmapAlignment align_with_submap(std::span<const Keyframe> keyframes,
                                                const SurfacePoints& points,
                                                const Pose2& T_odom_sensor,
                                                const AlignmentScale& scale,
                                                PointMarks& marks);

/// Mean closeness, 0 to 1, of all points to the surfaces of the keyframes, whichever way they face:
/// a score without gradient, for comparing poses that lie apart.
[[nodiscard]] double closeness_to_submap(std::span<const Keyframe> keyframes,
                                         const SurfacePoints& points,
                                         const Pose2& T_odom_sensor,
                                         double scale_m);

}  // namespace setsquare
