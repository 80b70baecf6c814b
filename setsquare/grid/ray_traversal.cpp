// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/grid/ray_traversal.hpp"

#include <cassert>
#include <cmath>

namespace setsquare {

SubcellPoint subcell_at(double x_cells, double y_cells) {
  constexpr auto kScale = static_cast<double>(kSubcellsPerCell);
  return {static_cast<std::int64_t>(std::floor(x_cells * kScale)),
          static_cast<std::int64_t>(std::floor(y_cells * kScale))};
}

RayTraversal::RayTraversal(SubcellPoint from, SubcellPoint to) : cell_(cell_of(from)) {
  const std::int64_t length_x = std::abs(to.x - from.x);
  const std::int64_t length_y = std::abs(to.y - from.y);
  assert(length_x <= kMaxRayCells * kSubcellsPerCell);
  assert(length_y <= kMaxRayCells * kSubcellsPerCell);
  const CellIndex end = cell_of(to);
  num_steps_ = std::abs(end.column - cell_.column) + std::abs(end.row - cell_.row);
  column_step_ = to.x < from.x ? -1 : 1;
  row_step_ = to.y < from.y ? -1 : 1;
  const auto to_next_side = [](std::int64_t position, std::int32_t step) {
    const std::int64_t in_cell = position & (kSubcellsPerCell - 1);
    return step < 0 ? in_cell : kSubcellsPerCell - in_cell;
  };
  // A side met at position / length of the way; both positions are compared without the division.
  lead_ =
      to_next_side(from.x, column_step_) * length_y - to_next_side(from.y, row_step_) * length_x;
  column_lead_ = kSubcellsPerCell * length_y;
  row_lead_ = kSubcellsPerCell * length_x;
  // A growing coordinate reaches the next cell on its side, a falling one only behind it.
  if (column_step_ > 0) --lead_;
}

}  // namespace setsquare
