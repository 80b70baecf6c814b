// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/point_set.hpp"

namespace setsquare {

/// The points in another frame, for a diagram.
[[nodiscard]] inline std::vector<Eigen::Vector2d> plotted_points(const PointSet& points,
                                                                 const Pose2& T_plot_points = {}) {
  std::vector<Eigen::Vector2d> plotted;
  plotted.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    plotted.emplace_back(T_plot_points * Eigen::Vector2d(points.x_m[i], points.y_m[i]));
  }
  return plotted;
}

}  // namespace setsquare
