// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "setsquare/sim/floor_plan.hpp"

namespace setsquare {

/// Normals of the walls that a plan's segments stand for. A round wall is drawn as a polygon; its
/// facets say nothing of the rotation of a scan that is taken in its middle, so along a run of
/// short segments (1.5 m at most) that meet at small angles (25 deg at most) the normal turns
/// steadily from each facet's middle to the next one's. Elsewhere it is that of the segment.
class WallNormals {
 public:
  explicit WallNormals(const FloorPlan& plan);

  /// A unit vector, either way across the wall, at a point of the segment.
  [[nodiscard]] Eigen::Vector2d normal_at(std::uint32_t segment, const Eigen::Vector2d& p_m) const;

 private:
  struct Facet {
    Eigen::Vector2d start_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d along = Eigen::Vector2d::UnitX();
    double length_m = 0.0;
    double turn_at_start_rad = 0.0;  // From the neighbour's direction to this one's; 0: a corner.
    double turn_at_end_rad = 0.0;    // From this direction to the neighbour's.
  };

  std::vector<Facet> facets_;  // One per segment.
};

}  // namespace setsquare
