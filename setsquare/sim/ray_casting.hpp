// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <optional>

#include "setsquare/sim/floor_plan.hpp"
#include "setsquare/sim/segment_grid.hpp"
#include "setsquare/sim/wall_normals.hpp"

namespace setsquare {

/// Where a ray meets the plan.
struct RayHit {
  double range_m = 0.0;
  std::uint32_t segment = 0;   ///< Index into the plan's segments.
  double incidence_cos = 0.0;  ///< Cosine of the angle to the segment's normal, in [0, 1].
};

/// Exact intersections of rays with the segments of a plan, found through a grid of cells.
/// Immutable: any number of threads may cast at once.
class RayCaster {
 public:
  /// Throws ParameterError where a corner of the plan is not finite or farther than 1e9 m.
  explicit RayCaster(FloorPlan plan);

  [[nodiscard]] const FloorPlan& plan() const { return plan_; }

  /// Normals of the walls, round ones included: `incidence_cos` is that to the segment's own.
  [[nodiscard]] const WallNormals& wall_normals() const { return wall_normals_; }

  /// The nearest hit farther than `from_m` and not beyond `max_range_m`; `direction` is a unit
  /// vector in the map frame. A segment seen exactly edge-on is not hit.
  [[nodiscard]] std::optional<RayHit> cast(const Eigen::Vector2d& origin_m,
                                           const Eigen::Vector2d& direction,
                                           double max_range_m,
                                           double from_m = 0.0) const;

 private:
  FloorPlan plan_;
  SegmentGrid grid_;
  WallNormals wall_normals_;
};

}  // namespace setsquare
