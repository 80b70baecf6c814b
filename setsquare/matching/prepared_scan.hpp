// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/matching/sweep_refinement.hpp"
#include "setsquare/surfaces/alignment.hpp"
#include "setsquare/surfaces/angle_histogram.hpp"
#include "setsquare/surfaces/surface_image.hpp"
#include "setsquare/surfaces/surface_points.hpp"
#include "setsquare/surfaces/surface_samples.hpp"

namespace setsquare {

/// What the default matcher needs of a scan: made once, matched any number of times, never changed.
struct PreparedScan {
  SurfacePoints points;
  SurfaceImage image;
  SurfaceSamples coarse;  ///< A few dozen samples: proposals live or die on them.
  SurfaceSamples fine;    ///< A few hundred, by weights that favour rare directions: the verdict.
  SurfaceSamples dense;   ///< As many as pay, by length of wall: the pose's last digits.
  std::vector<float> dense_from_middle_rad;  ///< Bearings of `dense` from the sweep's middle.
  double middle_rad = 0.0;                   ///< Bearing of the sweep's middle.
  AngleHistogram histogram;

  [[nodiscard]] AlignedScan coarse_alignment() const { return {image, coarse}; }
  [[nodiscard]] AlignedScan fine_alignment() const { return {image, fine}; }
  [[nodiscard]] AlignedScan dense_alignment() const { return {image, dense}; }
  [[nodiscard]] SweptScan swept() const {
    return {image, dense, dense_from_middle_rad, middle_rad};
  }
};

/// Throws ParameterError where the scan's geometry is no scan's (Scan::validate).
[[nodiscard]] PreparedScan prepare(const Scan& scan, const SurfaceParams& params = {});

}  // namespace setsquare
