// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/grid/scan_insertion.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/core/error.hpp"
#include "setsquare/grid/ray_traversal.hpp"

namespace setsquare {
namespace {

/// A cell that holds a return, and what it held before this scan.
struct Hit {
  std::size_t index;
  float log_odds_before;
};

SubcellPoint subcell_of(const OccupancyGrid& grid, const Eigen::Vector2d& p_grid) {
  return subcell_at(p_grid.x() / grid.resolution_m(), p_grid.y() / grid.resolution_m());
}

/// Frees all cells of the ray but the last.
void free_along(OccupancyGrid& grid, SubcellPoint from, SubcellPoint to, float pass, float lowest) {
  RayTraversal ray(from, to);
  float* const values = grid.values().data();
  const auto num_columns = static_cast<std::ptrdiff_t>(grid.num_columns());
  const bool is_inside = grid.contains(cell_of(from)) && grid.contains(cell_of(to));
  for (std::int32_t step = 0; step < ray.num_steps(); ++step, ray.advance()) {
    const CellIndex cell = ray.cell();
    if (!is_inside && !grid.contains(cell)) continue;
    float& value = values[cell.row * num_columns + cell.column];
    value = std::max(lowest, value + pass);
  }
}

}  // namespace

void ScanInsertionParams::validate() const {
  if (!(hit_log_odds > 0.0)) throw ParameterError("hit_log_odds", "must be positive");
  if (!(pass_log_odds < 0.0)) throw ParameterError("pass_log_odds", "must be negative");
  if (!(max_log_odds > 0.0)) throw ParameterError("max_log_odds", "must be positive");
  if (!(min_log_odds < 0.0)) throw ParameterError("min_log_odds", "must be negative");
  if (!(max_return_range_m > 0.0)) throw ParameterError("max_return_range_m", "must be positive");
  if (!(max_no_return_range_m >= 0.0)) {
    throw ParameterError("max_no_return_range_m", "must not be negative");
  }
}

std::vector<BeamEnd> beam_ends(const Scan& scan, const ScanInsertionParams& params) {
  std::vector<BeamEnd> ends;
  ends.reserve(scan.num_beams());
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    const BeamOutcome outcome = scan.outcome(beam);
    if (outcome == BeamOutcome::kInvalid) continue;
    const bool is_return =
        outcome == BeamOutcome::kReturn && scan.ranges_m[beam] <= params.max_return_range_m;
    const double range_m =
        is_return ? scan.ranges_m[beam] : std::min(params.max_no_return_range_m, scan.max_range_m);
    const double bearing_rad = scan.bearing_rad(beam);
    ends.push_back({range_m * std::cos(bearing_rad), range_m * std::sin(bearing_rad), is_return});
  }
  return ends;
}

void insert_beams(OccupancyGrid& grid,
                  const Pose2& T_map_sensor,
                  const std::vector<BeamEnd>& ends,
                  const ScanInsertionParams& params) {
  const Pose2 T_grid_sensor = grid.T_map_grid().inverse() * T_map_sensor;
  const double c = std::cos(T_grid_sensor.theta_rad);
  const double s = std::sin(T_grid_sensor.theta_rad);
  const SubcellPoint start = subcell_of(grid, T_grid_sensor.translation());
  std::vector<SubcellPoint> stops;
  std::vector<Hit> hits;
  stops.reserve(ends.size());
  hits.reserve(ends.size());
  for (const BeamEnd& end : ends) {
    const Eigen::Vector2d p_grid(T_grid_sensor.x_m + c * end.x_m - s * end.y_m,
                                 T_grid_sensor.y_m + s * end.x_m + c * end.y_m);
    stops.push_back(subcell_of(grid, p_grid));
    const CellIndex cell = cell_of(stops.back());
    if (end.is_return && grid.contains(cell))
      hits.push_back({grid.index(cell), grid.log_odds(cell)});
  }
  const auto pass = static_cast<float>(params.pass_log_odds);
  const auto lowest = static_cast<float>(params.min_log_odds);
  for (const SubcellPoint& stop : stops) free_along(grid, start, stop, pass, lowest);
  const auto gain = static_cast<float>(params.hit_log_odds);
  const auto highest = static_cast<float>(params.max_log_odds);
  for (const Hit& hit : hits) {
    grid.values()[hit.index] = std::min(highest, hit.log_odds_before + gain);
  }
}

void insert_scan(OccupancyGrid& grid,
                 const Pose2& T_map_sensor,
                 const Scan& scan,
                 const ScanInsertionParams& params) {
  insert_beams(grid, T_map_sensor, beam_ends(scan, params), params);
}

}  // namespace setsquare
