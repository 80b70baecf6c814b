// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/sensing/ray_casting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

constexpr double kCell_m = 0.5;
constexpr double kFarthest_m = 1e9;
constexpr double kMostCells = 4e6;  // A plan that is far too wide gets larger cells.
constexpr double kSlack = 1e-6;     // Of a cell: a segment along an edge belongs to both sides.
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The part of a ray inside a box: [enter, leave], empty where enter > leave.
struct RangeInterval {
  double enter_m;
  double leave_m;
};

void clip(double origin_m, double direction, double low_m, double high_m, RangeInterval& part) {
  if (direction == 0.0) {
    if (origin_m < low_m || origin_m > high_m) part.leave_m = -kInfinity;
    return;
  }
  const double to_low_m = (low_m - origin_m) / direction;
  const double to_high_m = (high_m - origin_m) / direction;
  part.enter_m = std::max(part.enter_m, std::min(to_low_m, to_high_m));
  part.leave_m = std::min(part.leave_m, std::max(to_low_m, to_high_m));
}

/// The walk along one axis of the grid.
struct AxisWalk {
  std::ptrdiff_t cell;
  std::ptrdiff_t step;
  double next_edge_m;  // Range at which the ray leaves the cell along this axis.
  double edge_step_m;  // Range from one edge to the next.
};

/// `from_corner_m` and `direction`: the ray's origin and direction along this axis.
AxisWalk start_walk(
    double from_corner_m, double direction, double enter_m, double cell_m, std::size_t num_cells) {
  const double at_cell = (from_corner_m + enter_m * direction) / cell_m;
  const double last = static_cast<double>(num_cells) - 1.0;
  AxisWalk walk{static_cast<std::ptrdiff_t>(std::clamp(std::floor(at_cell), 0.0, last)),
                direction < 0.0 ? -1 : 1,
                kInfinity,
                kInfinity};
  if (direction == 0.0) return walk;
  const double edge_m = static_cast<double>(walk.cell + (direction > 0.0 ? 1 : 0)) * cell_m;
  walk.next_edge_m = (edge_m - from_corner_m) / direction;
  walk.edge_step_m = cell_m / std::abs(direction);
  return walk;
}

}  // namespace

SegmentGrid::SegmentGrid(const FloorPlan& plan) {
  for (const PlanSegment& segment : plan.segments) {
    for (const Eigen::Vector2d& corner_m : {segment.start_m, segment.end_m}) {
      if (!(corner_m.cwiseAbs().maxCoeff() <= kFarthest_m)) {
        throw ParameterError("segments", "a corner of the floor plan is not finite or too far");
      }
    }
  }
  if (plan.segments.empty()) return;
  lay_out(plan);
  fill(plan);
}

void SegmentGrid::lay_out(const FloorPlan& plan) {
  Eigen::Array2d low = plan.segments.front().start_m;
  Eigen::Array2d high = low;
  for (const PlanSegment& segment : plan.segments) {
    low = low.min(segment.start_m.array()).min(segment.end_m.array());
    high = high.max(segment.start_m.array()).max(segment.end_m.array());
  }
  const Eigen::Array2d extent = high - low;
  cell_m_ =
      std::max({kCell_m, std::sqrt(extent.prod() / kMostCells), extent.maxCoeff() / kMostCells});
  corner_m_ = low - 0.5 * cell_m_;
  num_columns_ = static_cast<std::size_t>(extent.x() / cell_m_) + 2;
  num_rows_ = static_cast<std::size_t>(extent.y() / cell_m_) + 2;
}

/// Calls visit(cell) for every cell that the segment touches: row by row, the columns that it spans
/// within that row.
template <typename Visit>
void SegmentGrid::visit_cells(const PlanSegment& segment, const Visit& visit) const {
  Eigen::Vector2d low = (segment.start_m - corner_m_) / cell_m_;
  Eigen::Vector2d high = (segment.end_m - corner_m_) / cell_m_;
  if (low.y() > high.y()) std::swap(low, high);
  const double height = high.y() - low.y();
  const bool is_flat = height < 4.0 * kSlack;
  const double columns_a_row = is_flat ? 0.0 : (high.x() - low.x()) / height;
  const auto column_of = [&](double x) {
    return static_cast<std::size_t>(std::clamp(x, 0.0, static_cast<double>(num_columns_) - 1.0));
  };
  const auto last_row = static_cast<std::size_t>(high.y() + kSlack);
  for (auto row = static_cast<std::size_t>(low.y() - kSlack); row <= last_row; ++row) {
    const double row_y = static_cast<double>(row);
    const double enter = std::clamp(row_y - kSlack - low.y(), 0.0, height);
    const double leave = std::clamp(row_y + 1.0 + kSlack - low.y(), 0.0, height);
    double first_x = low.x() + columns_a_row * enter;
    double last_x = is_flat || row == last_row ? high.x() : low.x() + columns_a_row * leave;
    if (first_x > last_x) std::swap(first_x, last_x);
    const std::size_t last_column = column_of(last_x + kSlack);
    for (std::size_t column = column_of(first_x - kSlack); column <= last_column; ++column) {
      visit(row * num_columns_ + column);
    }
  }
}

void SegmentGrid::fill(const FloorPlan& plan) {
  first_entry_.assign(num_cells() + 1, 0);
  for (const PlanSegment& segment : plan.segments) {
    visit_cells(segment, [&](std::size_t cell) { ++first_entry_[cell + 1]; });
  }
  for (std::size_t cell = 0; cell < num_cells(); ++cell) {
    first_entry_[cell + 1] += first_entry_[cell];
  }
  entries_.resize(first_entry_.back());
  std::vector<std::uint32_t> next(first_entry_.begin(), first_entry_.end() - 1);
  for (std::uint32_t i = 0; i < plan.segments.size(); ++i) {
    const PlanSegment& segment = plan.segments[i];
    visit_cells(segment, [&](std::size_t cell) {
      entries_[next[cell]++] = {segment.start_m, segment.end_m, i};
    });
  }
}

std::optional<SegmentHit> SegmentGrid::cast(const Ray& ray,
                                            double from_m,
                                            double max_range_m) const {
  if (entries_.empty()) return std::nullopt;
  const Eigen::Vector2d origin = ray.origin_m - corner_m_;
  const Eigen::Vector2d& direction = ray.direction;
  RangeInterval inside{from_m, max_range_m};
  clip(origin.x(), direction.x(), 0.0, static_cast<double>(num_columns_) * cell_m_, inside);
  clip(origin.y(), direction.y(), 0.0, static_cast<double>(num_rows_) * cell_m_, inside);
  if (!(inside.enter_m <= inside.leave_m)) return std::nullopt;

  AxisWalk x = start_walk(origin.x(), direction.x(), inside.enter_m, cell_m_, num_columns_);
  AxisWalk y = start_walk(origin.y(), direction.y(), inside.enter_m, cell_m_, num_rows_);
  const auto num_columns = static_cast<std::ptrdiff_t>(num_columns_);
  const auto num_rows = static_cast<std::ptrdiff_t>(num_rows_);
  SegmentHit nearest{kInfinity, 0};
  while (x.cell >= 0 && x.cell < num_columns && y.cell >= 0 && y.cell < num_rows) {
    const std::ptrdiff_t cell = y.cell * num_columns + x.cell;
    for (std::uint32_t i = first_entry_[cell]; i < first_entry_[cell + 1]; ++i) {
      const auto range_m = range_to_segment(ray, entries_[i].start_m, entries_[i].end_m);
      if (range_m && *range_m > from_m && *range_m < nearest.range_m) {
        nearest = {*range_m, entries_[i].segment};
      }
    }
    AxisWalk& next = x.next_edge_m < y.next_edge_m ? x : y;
    if (nearest.range_m <= next.next_edge_m || next.next_edge_m > max_range_m) break;
    next.cell += next.step;
    next.next_edge_m += next.edge_step_m;
  }
  if (!(nearest.range_m <= max_range_m)) return std::nullopt;
  return nearest;
}

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
