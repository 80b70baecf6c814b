// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// How returns are joined to surfaces.
struct SurfaceParams {
  double max_range_m = 30.0;        ///< Returns beyond it are not used.
  double join_distance_m = 0.15;    ///< Neighbours nearer than this belong to one surface ...
  double join_beam_spacings = 3.0;  ///< ... or nearer than so many beam spacings at their range.
  double collinear_tolerance_m = 0.04;  ///< Farther neighbours join where four in a row fit a line.
  double max_join_m = 4.0;              ///< No surface spans a wider gap.
  double fit_radius_m = 0.30;  ///< The line at a return is fitted to its joined neighbours so near.
  double max_fit_rms_m = 0.025;  ///< A fit that is worse than this is a corner or clutter.
  double max_weight_m = 0.20;    ///< A return stands for at most this length of wall.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// The returns of a scan with the surface that each lies on, in the order of the beams. Plain
/// arrays in the sensor frame, float because the kernels that read them are short of width, not of
/// digits (10 m have 1 um).
struct SurfacePoints {
  std::vector<float> x_m;
  std::vector<float> y_m;
  std::vector<float>
      normal_x;  ///< Unit normal of the wall, facing the sensor; zero where no line fits.
  std::vector<float> normal_y;
  std::vector<float> weight_m;  ///< Length of wall that the return stands for.
  std::vector<float> range_m;
  std::vector<std::int32_t> beam;
  std::vector<std::uint8_t> joined;  ///< Whether the surface continues to the next return.

  [[nodiscard]] std::size_t size() const { return x_m.size(); }
};

/// Joins neighbouring returns where they are close or collinear and fits a line at each.
///
/// 1. A return becomes a point; its neighbour belongs to the same surface if it is near, or if the
///    two and their neighbours lie on one line (a wall seen at a grazing angle).
/// 2. At each point a line is fitted to the joined neighbours around it, or to those on one side
///    where the surface bends.
[[nodiscard]] SurfacePoints surface_points_from_scan(const Scan& scan,
                                                     const SurfaceParams& params = {});

}  // namespace setsquare
