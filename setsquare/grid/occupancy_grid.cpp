// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/grid/occupancy_grid.hpp"

#include <cmath>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

std::size_t checked_num_cells(double resolution_m,
                              std::int32_t num_columns,
                              std::int32_t num_rows) {
  if (!(resolution_m > 0.0) || !std::isfinite(resolution_m)) {
    throw ParameterError("resolution_m", "must be positive");
  }
  if (num_columns <= 0) throw ParameterError("num_columns", "must be positive");
  if (num_rows <= 0) throw ParameterError("num_rows", "must be positive");
  const std::int64_t num_cells = std::int64_t{num_columns} * num_rows;
  if (num_cells > OccupancyGrid::kMaxCells) {
    throw ParameterError("resolution_m", "is too fine for a grid of this extent");
  }
  return static_cast<std::size_t>(num_cells);
}

}  // namespace

OccupancyGrid::OccupancyGrid(const Pose2& T_map_grid,
                             double resolution_m,
                             std::int32_t num_columns,
                             std::int32_t num_rows)
    : T_map_grid_(T_map_grid),
      resolution_m_(resolution_m),
      num_columns_(num_columns),
      num_rows_(num_rows),
      log_odds_(checked_num_cells(resolution_m, num_columns, num_rows), 0.0F) {}

double OccupancyGrid::probability(CellIndex cell) const {
  return 1.0 / (1.0 + std::exp(-static_cast<double>(log_odds(cell))));
}

}  // namespace setsquare
