// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "setsquare/scan/scan.hpp"
#include "setsquare/surfaces/alignment.hpp"
#include "setsquare/surfaces/angle_histogram.hpp"
#include "setsquare/surfaces/surface_image.hpp"
#include "setsquare/surfaces/surface_points.hpp"
#include "setsquare/surfaces/surface_samples.hpp"

namespace setsquare {

/// A scan made into surfaces. This is the costly part of preparing a scan; it is done once, and
/// tracking, matching and mapping share it.
struct ScanSurfaces {
  SurfacePoints points;           ///< The returns with their lines.
  SurfaceImage image;             ///< Made of the points.
  double sweep_middle_rad = 0.0;  ///< Bearing of the sweep's middle.
};
/// Shared, never changed.
using ScanSurfacesPtr = std::shared_ptr<const ScanSurfaces>;

/// The surfaces of a scan. Throws ParameterError where its geometry is not valid (Scan::validate).
[[nodiscard]] ScanSurfacesPtr scan_surfaces(const Scan& scan,
                                            const SurfaceParams& params = {},
                                            const SurfaceImage::Params& image_params = {});
/// The same from surface points that were made of the scan before.
[[nodiscard]] ScanSurfacesPtr scan_surfaces(const Scan& scan,
                                            SurfacePoints points,
                                            const SurfaceImage::Params& image_params);

/// A scan whose samples were measured one after the other.
struct SweptScan {
  const SurfaceImage& image;                  ///< Its surfaces.
  const SurfaceSamples& samples;              ///< What was measured one after the other.
  const std::vector<float>& from_middle_rad;  ///< Bearing from middle_rad, one per sample.
  double middle_rad = 0.0;  ///< Bearing of the sweep's middle, when the scan's pose is meant.
};

/// The bearing of (x, y) from `middle_rad`, in [-pi, pi), within 0.005 rad.
[[nodiscard]] float bearing_from(float middle_rad, float x_m, float y_m);

/// Bearings of the samples from the sweep's middle, in [-pi, pi).
[[nodiscard]] std::vector<float> bearings_from(double middle_rad, const SurfaceSamples& samples);

/// What the default matcher needs of a scan: made once, matched any number of times, never changed.
struct PreparedScan {
  ScanSurfacesPtr surfaces;  ///< Never null.
  SurfaceSamples coarse;     ///< A few dozen samples: they decide on proposals.
  SurfaceSamples fine;   ///< A few hundred, by weights that favour rare directions: the verdict.
  SurfaceSamples dense;  ///< As many as help, by length of wall: the pose's last digits.
  std::vector<float> dense_from_middle_rad;  ///< Bearings of `dense` from the sweep's middle.
  AngleHistogram histogram;                  ///< Of the surfaces' points.

  /// The surfaces' points.
  [[nodiscard]] const SurfacePoints& points() const { return surfaces->points; }
  /// The surfaces' image.
  [[nodiscard]] const SurfaceImage& image() const { return surfaces->image; }
  /// What align() takes for a quick look.
  [[nodiscard]] AlignedScan coarse_alignment() const { return {image(), coarse}; }
  /// What it takes for the verdict.
  [[nodiscard]] AlignedScan fine_alignment() const { return {image(), fine}; }
  /// What it takes for the last digits.
  [[nodiscard]] AlignedScan dense_alignment() const { return {image(), dense}; }
  /// The dense samples with the time at which each was measured.
  [[nodiscard]] SweptScan swept() const {
    return {image(), dense, dense_from_middle_rad, surfaces->sweep_middle_rad};
  }
};

/// Throws ParameterError where the scan's geometry is not valid (Scan::validate).
[[nodiscard]] PreparedScan prepare(const Scan& scan,
                                   const SurfaceParams& params = {},
                                   const SampleParams& samples = {});
/// The same from surfaces that were made before: only the samples are drawn.
[[nodiscard]] PreparedScan prepare(ScanSurfacesPtr surfaces, const SampleParams& samples = {});

}  // namespace setsquare
