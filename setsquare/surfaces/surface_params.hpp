// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Parameters of surfaces: of the points, of the image, of the samples.
#pragma once

#include <cstddef>

namespace setsquare {

/// How returns are joined to surfaces.
struct SurfaceParams {
  double max_range_m = 30.0;        ///< Returns beyond it are not used.
  double join_distance_m = 0.15;    ///< Neighbours nearer than this belong to one surface ...
  double join_beam_spacings = 3.0;  ///< ... or nearer than this many beam spacings at their range.
  double collinear_tolerance_m = 0.04;  ///< Farther neighbours join where four in a row fit a line.
  double max_join_m = 4.0;              ///< No surface spans a wider gap.
  double fit_radius_m = 0.30;  ///< The line at a return is fitted to its joined neighbours within.
  double max_fit_rms_m = 0.025;  ///< A fit that is worse than this is a corner or clutter.
  double max_weight_m = 0.20;    ///< A return stands for at most this length of wall.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of SurfaceImage.
struct SurfaceImageParams {
  double no_return_free_m = 6.0;    ///< A beam without return proves free space up to here.
  double free_margin_m = 0.20;      ///< Nothing is called free nearer than this to a return ...
  double free_margin_ratio = 0.03;  ///< ... plus this share of the range.

  /// Throws ParameterError that names the field, with "image." in front.
  void validate() const;
};

/// How many samples stand for a scan.
struct SampleParams {
  std::size_t max_coarse = 60;   ///< At most CorrelationGrid::kMaxSamples.
  std::size_t max_fine = 400;    ///< A few hundred decide as well as all do.
  std::size_t max_dense = 1200;  ///< More make the pose no better.

  /// Throws ParameterError that names the field.
  void validate() const;
};

}  // namespace setsquare
