// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "setsquare/scan/scan.hpp"
#include "setsquare/surfaces/surface_params.hpp"

namespace setsquare {

/// The returns of a scan with the surface that each lies on, in the order of the beams. Plain
/// arrays in the sensor frame, float because the kernels that read them are short of width, not of
/// digits (10 m have 1 um).
struct SurfacePoints {
  std::vector<float> x_m;  ///< Forward of the sensor.
  std::vector<float> y_m;  ///< To its left.
  std::vector<float>
      normal_x;  ///< Unit normal of the wall, facing the sensor; zero where no line fits.
  std::vector<float> normal_y;       ///< See normal_x.
  std::vector<float> weight_m;       ///< Length of wall that the return stands for.
  std::vector<float> range_m;        ///< From the sensor.
  std::vector<std::int32_t> beam;    ///< That each return came by.
  std::vector<std::uint8_t> joined;  ///< Whether the surface continues to the next return.

  /// The number of returns.
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
