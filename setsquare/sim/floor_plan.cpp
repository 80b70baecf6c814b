// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/floor_plan.hpp"

#include <cstddef>

namespace setsquare {

void add_polyline(FloorPlan& plan,
                  const std::vector<Eigen::Vector2d>& corners_m,
                  Material material,
                  bool closed) {
  for (std::size_t i = 1; i < corners_m.size(); ++i)
    plan.segments.push_back({corners_m[i - 1], corners_m[i], material});
  if (closed && corners_m.size() > 2)
    plan.segments.push_back({corners_m.back(), corners_m.front(), material});
}

}  // namespace setsquare
