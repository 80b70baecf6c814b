// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/expected_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "setsquare/localisation/map_correlation.hpp"

namespace setsquare {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Unknown space that a ray may cross on its way to a wall: single cells were never passed.
constexpr double kMaxUnknown_m = 0.3;
/// ... and about a sensor that stands in such space this much: where a robot stands it is free.
constexpr double kUnknownAboutSensor_m = 1.0;
static_assert(kUnknownAboutSensor_m >= MapCorrelation::kBeyondFree_m);

}  // namespace

double range_to_wall(const WallDistance& walls,
                     double x_m,
                     double y_m,
                     const Eigen::Vector2d& direction,
                     double max_range_m) {
  // Everything in cells. Far from walls the ray jumps as far as none can be; near them it goes from
  // cell to cell (Amanatides and Woo 1987). Most of a search's time is spent here
  // (benchmarks/localisation).
  const double per_m = 1.0 / walls.resolution_m();
  const double x = x_m * per_m;
  const double y = y_m * per_m;
  const double dx = direction.x();
  const double dy = direction.y();
  const double end = max_range_m * per_m;
  const int step_x = dx >= 0.0 ? 1 : -1;
  const int step_y = dy >= 0.0 ? 1 : -1;
  const double per_column = std::abs(dx) > 1e-12 ? 1.0 / std::abs(dx) : kNever;
  const double per_row = std::abs(dy) > 1e-12 ? 1.0 / std::abs(dy) : kNever;
  const auto num_columns = static_cast<double>(walls.num_columns());
  const auto num_rows = static_cast<double>(walls.num_rows());

  double t = 0.0;
  CellIndex cell{};
  double next_column = 0.0;
  double next_row = 0.0;
  const auto lands_inside = [&](double at) {
    t = at;
    const double px = x + t * dx;
    const double py = y + t * dy;
    if (!(px >= 0.0 && py >= 0.0 && px < num_columns && py < num_rows)) return false;
    cell = {static_cast<std::int32_t>(px), static_cast<std::int32_t>(py)};
    const double in_column = px - cell.column;
    const double in_row = py - cell.row;
    next_column =
        per_column == kNever ? kNever : t + (step_x > 0 ? 1.0 - in_column : in_column) * per_column;
    next_row = per_row == kNever ? kNever : t + (step_y > 0 ? 1.0 - in_row : in_row) * per_row;
    return true;
  };
  constexpr double kNear_cells = 4.0;
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const double max_unknown = kMaxUnknown_m * per_m;
  double known_until = (kUnknownAboutSensor_m - kMaxUnknown_m) * per_m;
  bool is_inside = lands_inside(0.0);
  while (t < end) {
    if (!is_inside) return kUnknown;
    const CellState state = walls.state_inside(cell);
    if (state == CellState::kOccupied) {
      const double leave = std::min(next_column, next_row);
      const double nearest = (cell.column + 0.5 - x) * dx + (cell.row + 0.5 - y) * dy;
      return walls.resolution_m() * std::clamp(nearest, t, std::max(t, leave));
    }
    if (state != CellState::kUnknown) known_until = t;
    if (t - known_until > max_unknown) return kUnknown;
    const double clear = walls.distance_m(cell) * per_m;
    if (clear > kNear_cells) {
      is_inside = lands_inside(t + clear - 2.0);
    } else if (next_column < next_row) {
      t = next_column;
      next_column += per_column;
      cell.column += step_x;
      is_inside = cell.column >= 0 && cell.column < walls.num_columns();
    } else {
      t = next_row;
      next_row += per_row;
      cell.row += step_y;
      is_inside = cell.row >= 0 && cell.row < walls.num_rows();
    }
  }
  return kNever;
}

BeamLayout layout_of(const Scan& scan) {
  constexpr double kMinStep_rad = rad_from_deg(0.5);
  constexpr double kMaxRange_m = 30.0;
  BeamLayout layout{.first_bearing_rad = scan.first_bearing_rad,
                    .bearing_step_rad = scan.bearing_step_rad,
                    .num_beams = scan.num_beams(),
                    .max_range_m = std::min(kMaxRange_m, scan.max_range_m)};
  const double step_rad = std::abs(scan.bearing_step_rad);
  if (step_rad > 0.0 && step_rad < kMinStep_rad && scan.num_beams() > 1) {
    const auto num_steps = static_cast<std::size_t>(
        std::max(1.0, std::floor(scan.field_of_view_rad() / kMinStep_rad + 0.5)));
    layout.num_beams = num_steps + 1;
    layout.bearing_step_rad = std::copysign(
        scan.field_of_view_rad() / static_cast<double>(num_steps), scan.bearing_step_rad);
  }
  return layout;
}

Scan expected_scan(const WallDistance& walls, const BeamLayout& beams, const Pose2& T_grid_sensor) {
  Scan scan;
  scan.first_bearing_rad = beams.first_bearing_rad;
  scan.bearing_step_rad = beams.bearing_step_rad;
  scan.max_range_m = beams.max_range_m;
  scan.ranges_m.reserve(beams.num_beams);
  const Eigen::Matrix2d turn = rotation_matrix(beams.bearing_step_rad);
  Eigen::Vector2d direction =
      rotation_matrix(T_grid_sensor.theta_rad + beams.first_bearing_rad).col(0);
  for (std::size_t beam = 0; beam < beams.num_beams; ++beam) {
    scan.ranges_m.push_back(
        range_to_wall(walls, T_grid_sensor.x_m, T_grid_sensor.y_m, direction, beams.max_range_m));
    direction = turn * direction;
  }
  return scan;
}

}  // namespace setsquare
