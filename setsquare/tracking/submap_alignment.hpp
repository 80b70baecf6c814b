// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/surfaces/surface_samples.hpp"
#include "setsquare/tracking/keyframe.hpp"
#include "setsquare/tracking/scan_tracker_params.hpp"

namespace setsquare {

/// A scan against a submap at one pose: what agrees, and the normal equations of the point-to-line
/// distances in (x, y, theta) of T_submap_sensor, summed over the submap's images and divided by
/// the number of images that saw a point's surroundings: a point counts once, however often it was
/// seen.
struct SubmapAlignment {
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();   ///< points x (1, m, m^2)
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< points x m x (1, m)
  double num_compared = 0.0;      ///< Points that fall where some image shows a surface.
  double num_explained = 0.0;     ///< Of these, on the surface of some image.
  double num_contradicted = 0.0;  ///< Of these, on none and where some image saw through.

  /// Share explained less share contradicted, -1 to 1.
  [[nodiscard]] double score() const {
    return num_compared > 0.0 ? (num_explained - num_contradicted) / num_compared : -1.0;
  }
};

/// Reused between calls; holds what each point met.
using PointMarks = std::vector<std::int32_t>;

/// Whether a point met a surface of some image within 0.1 m.
[[nodiscard]] bool is_explained(std::int32_t mark);

/// Compares the points, each with the line that each image shows in its direction. Weights of the
/// samples have no part: every point counts the same.
[[nodiscard]] SubmapAlignment align_with_submap(std::span<const PlacedImage> submap,
                                                const SurfaceSamples& points,
                                                const Pose2& T_submap_sensor,
                                                const AlignmentScale& scale,
                                                PointMarks& marks);

/// Mean closeness, 0 to 1, of all points to the surfaces of the images, whichever way they face:
/// a score without gradient, for comparing poses that lie apart.
[[nodiscard]] double closeness_to_submap(std::span<const PlacedImage> submap,
                                         const SurfaceSamples& points,
                                         const Pose2& T_submap_sensor,
                                         double scale_m);

}  // namespace setsquare
