// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "setsquare/sim/floor_plan.hpp"
#include "setsquare/sim/sensing/wall_normals.hpp"

namespace setsquare {
/// A ray in the map frame: origin_m + range * direction, `direction` of length 1.
struct Ray {
  Eigen::Vector2d origin_m;
  Eigen::Vector2d direction;
};

/// Where a ray meets which segment.
struct SegmentHit {
  double range_m = 0.0;
  std::uint32_t segment = 0;  ///< Index into the plan's segments.
};

/// Range at which a ray's line meets a segment (negative: behind the origin); nothing where it does
/// not, or only edge-on. Two segments that share a corner leave no gap there: which side of the ray
/// a corner lies on is computed from that corner alone.
[[nodiscard]] inline std::optional<double> range_to_segment(const Ray& ray,
                                                            const Eigen::Vector2d& start_m,
                                                            const Eigen::Vector2d& end_m) {
  const double start_x = start_m.x() - ray.origin_m.x();
  const double start_y = start_m.y() - ray.origin_m.y();
  const double end_x = end_m.x() - ray.origin_m.x();
  const double end_y = end_m.y() - ray.origin_m.y();
  const double start_side = ray.direction.x() * start_y - ray.direction.y() * start_x;
  const double end_side = ray.direction.x() * end_y - ray.direction.y() * end_x;
  if ((start_side > 0.0 && end_side > 0.0) || (start_side < 0.0 && end_side < 0.0)) {
    return std::nullopt;
  }
  const double across = end_side - start_side;
  const double dx = end_x - start_x;
  const double dy = end_y - start_y;
  // Edge-on: a sine of less than 1e-9 between ray and segment does not determine the range.
  if (across * across <= 1e-18 * (dx * dx + dy * dy)) return std::nullopt;
  return (start_x * dy - start_y * dx) / across;
}

/// The segments of a plan by the cells of a uniform grid over their bounding box.
class SegmentGrid {
 public:
  /// Throws ParameterError where a corner is not finite or farther than 1e9 m.
  explicit SegmentGrid(const FloorPlan& plan);

  /// The nearest hit with from_m < range <= max_range_m.
  [[nodiscard]] std::optional<SegmentHit> cast(const Ray& ray,
                                               double from_m,
                                               double max_range_m) const;

  [[nodiscard]] std::size_t num_cells() const { return num_columns_ * num_rows_; }

 private:
  struct Entry {
    Eigen::Vector2d start_m;
    Eigen::Vector2d end_m;
    std::uint32_t segment = 0;
  };

  void lay_out(const FloorPlan& plan);
  void fill(const FloorPlan& plan);
  template <typename Visit>
  void visit_cells(const PlanSegment& segment, const Visit& visit) const;

  Eigen::Vector2d corner_m_ = Eigen::Vector2d::Zero();  // Of the lowest cell.
  double cell_m_ = 1.0;
  std::size_t num_columns_ = 0;
  std::size_t num_rows_ = 0;
  std::vector<std::uint32_t> first_entry_;  // One per cell, row by row, and the end.
  std::vector<Entry> entries_;              // By cell.
};

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
