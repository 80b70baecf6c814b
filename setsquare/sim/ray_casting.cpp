// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/ray_casting.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace setsquare {

RayCaster::RayCaster(FloorPlan plan) : plan_(std::move(plan)), grid_(plan_), wall_normals_(plan_) {}

std::optional<RayHit> RayCaster::cast(const Eigen::Vector2d& origin_m,
                                      const Eigen::Vector2d& direction,
                                      double max_range_m,
                                      double from_m) const {
  const auto hit = grid_.cast({origin_m, direction}, from_m, max_range_m);
  if (!hit) return std::nullopt;
  const PlanSegment& segment = plan_.segments[hit->segment];
  const Eigen::Vector2d along = (segment.end_m - segment.start_m).normalized();
  const double incidence_cos = std::abs(direction.x() * along.y() - direction.y() * along.x());
  return RayHit{hit->range_m, hit->segment, std::min(incidence_cos, 1.0)};
}

}  // namespace setsquare
