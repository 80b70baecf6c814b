// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/sim/floor_plan.hpp"

namespace setsquare {

/// A building given as square cells.
struct PlanCells {
  Pose2 T_map_cells;  ///< Pose of the lower left corner; the axes run along rows and columns.
  double resolution_m = 0.0;
  std::size_t num_columns = 0;
  std::size_t num_rows = 0;
  /// One per cell, row by row from the lowest: not 0 where the cell is filled.
  std::vector<std::uint8_t> is_filled;

  /// Throws ParameterError where the resolution is not positive or the numbers do not agree.
  void validate() const;
};

/// The outlines of the filled cells as walls: the edges between a filled cell and one that is not,
/// those in one line joined into one segment. What lies beyond the cells is not filled. Walls that
/// do not run along the cells come out as stairs, as the cells have them. Throws ParameterError.
[[nodiscard]] FloorPlan floor_plan_from_cells(const PlanCells& cells,
                                              Material material = Material::kWall);

}  // namespace setsquare
