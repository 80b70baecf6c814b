// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/surfaces/surface_params.hpp"
#include "setsquare/surfaces/surface_points.hpp"

namespace setsquare {

/// Some of a scan's surface points, each standing for its share of the seen wall. Plain arrays in
/// the sensor frame.
struct SurfaceSamples {
  std::vector<float> x_m;       ///< Forward of the sensor.
  std::vector<float> y_m;       ///< To its left.
  std::vector<float> normal_x;  ///< Zero where no line fits.
  std::vector<float> normal_y;  ///< See normal_x.
  std::vector<float> weight_m;  ///< Length of wall that each stands for.

  std::size_t count =
      0;  ///< The arrays are longer: padded to whole vectors with weightless points.

  /// The number of samples, without the padding.
  [[nodiscard]] std::size_t size() const { return count; }
  /// The length of the arrays: a multiple of the vectors' width.
  [[nodiscard]] std::size_t padded_size() const { return x_m.size(); }
};

/// At most `max_samples` points, evenly spaced along the seen wall (systematic sampling by weight);
/// all points where there are no more than that.
[[nodiscard]] SurfaceSamples sample_surface(const SurfacePoints& points, std::size_t max_samples);

/// The same by other weights than the points' own, one per point, in m.
[[nodiscard]] SurfaceSamples sample_surface(const SurfacePoints& points,
                                            std::span<const float> weights_m,
                                            std::size_t max_samples);

}  // namespace setsquare
