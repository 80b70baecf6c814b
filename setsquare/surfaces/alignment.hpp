// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>

#include "setsquare/core/pose2.hpp"
#include "setsquare/surfaces/surface_image.hpp"
#include "setsquare/surfaces/surface_samples.hpp"

namespace setsquare {

/// How one set of samples falls on a scan's surfaces, in metres of wall.
struct Evidence {
  double wall_m = 0.0;          ///< All that was compared.
  double agreeing_m = 0.0;      ///< On the surface (weighted by nearness), facing the same way.
  double contradicted_m = 0.0;  ///< Where the scan saw through.
  double hidden_m = 0.0;        ///< Behind the surface: the scan could not see it.
  double outside_m = 0.0;       ///< Outside the field of view, or where no beam came back.

  /// Adds the other's metres.
  Evidence& operator+=(const Evidence& other);
};

/// The evidence and the normal equations of the point-to-line distances at one relative pose.
/// `hessian` and `gradient` are in (x, y, theta) of T_reference_current, distances weighted by
/// metres of wall and by Tukey's biweight of width `tolerance_m`.
struct Alignment {
  Evidence evidence;                                   ///< At the pose.
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();   ///< m of wall x (1, m, m^2)
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< m of wall x m x (1, m)
};

/// What `align` needs of a scan.
struct AlignedScan {
  const SurfaceImage& image;      ///< Its surfaces.
  const SurfaceSamples& samples;  ///< Its samples: coarse, fine or dense.
};

/// Compares both ways: the current scan's samples with the reference's surfaces and the reference's
/// samples with the current's surfaces.
[[nodiscard]] Alignment align(const AlignedScan& reference,
                              const AlignedScan& current,
                              const Pose2& T_reference_current,
                              double tolerance_m);

/// One way only: samples in frame `b` against the image of frame `a`.
[[nodiscard]] Alignment align_one_way(const SurfaceImage& image_a,
                                      const SurfaceSamples& samples_b,
                                      const Pose2& T_a_b,
                                      double tolerance_m);

/// Gauss-Newton steps point to line, both ways, one step per tolerance: wide ones first to catch,
/// narrow ones last to settle. Where the walls leave a direction open the pose stays put along it.
[[nodiscard]] Pose2 refine(const AlignedScan& reference,
                           const AlignedScan& current,
                           const Pose2& T_reference_current,
                           std::span<const double> tolerances_m);

}  // namespace setsquare
