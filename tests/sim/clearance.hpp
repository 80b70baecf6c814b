// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <Eigen/Core>
#include <limits>
#include <vector>

#include "setsquare/sim/floor_plan.hpp"

namespace setsquare {

/// Distance from a point to the nearest segment of a plan.
[[nodiscard]] inline double clearance_m(const FloorPlan& plan, const Eigen::Vector2d& point_m) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const PlanSegment& segment : plan.segments) {
    const Eigen::Vector2d along = segment.end_m - segment.start_m;
    const double share =
        std::clamp((point_m - segment.start_m).dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (segment.start_m + share * along - point_m).norm());
  }
  return nearest;
}

/// The least clearance along a straight way, in steps of at most 5 cm.
[[nodiscard]] inline double clearance_m(const FloorPlan& plan,
                                        const Eigen::Vector2d& from_m,
                                        const Eigen::Vector2d& to_m) {
  const int num_steps = 1 + static_cast<int>((to_m - from_m).norm() / 0.05);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= num_steps; ++i)
    least = std::min(
        least, clearance_m(plan, from_m + (static_cast<double>(i) / num_steps) * (to_m - from_m)));
  return least;
}

}  // namespace setsquare
