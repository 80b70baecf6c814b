// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace setsquare {

/// Returns of a scan as Cartesian points in the sensor frame, in the order of the beams. Plain
/// arrays, one per coordinate: the kernels run over them.
struct PointSet {
  std::vector<double> x_m;         ///< Forward of the sensor.
  std::vector<double> y_m;         ///< To its left.
  std::vector<std::int32_t> beam;  ///< The beam that each point came from.

  /// The number of points.
  [[nodiscard]] std::size_t size() const { return x_m.size(); }
  /// Whether there is no point.
  [[nodiscard]] bool empty() const { return x_m.empty(); }
  /// Makes room for so many points.
  void reserve(std::size_t num_points) {
    x_m.reserve(num_points);
    y_m.reserve(num_points);
    beam.reserve(num_points);
  }
  /// Appends a point in the sensor frame, with the number of its beam.
  void push_back(double point_x_m, double point_y_m, std::int32_t point_beam) {
    x_m.push_back(point_x_m);
    y_m.push_back(point_y_m);
    beam.push_back(point_beam);
  }
};

}  // namespace setsquare
