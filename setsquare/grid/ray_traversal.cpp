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
  both_leads_ = column_lead_ + row_lead_;
  // A growing coordinate reaches the next cell on its side, a falling one only behind it.
  if (column_step_ > 0) --lead_;
}

std::int64_t RayTraversal::num_columns_before_row(std::int32_t row) const {
  // The n-th row step is due once (columns * column_lead - (n - 1) * row_lead + lead) >= 0.
  const std::int64_t num_rows = std::abs(row - cell_.row);
  const std::int64_t behind = (num_rows - 1) * row_lead_ - lead_;
  return behind <= 0 ? 0 : (behind + column_lead_ - 1) / column_lead_;
}

std::int32_t RayTraversal::num_steps_to_row(std::int32_t row) const {
  if (row == cell_.row) return 0;
  return static_cast<std::int32_t>(num_columns_before_row(row)) + std::abs(row - cell_.row);
}

void RayTraversal::advance_to_row(std::int32_t row) {
  if (row == cell_.row) return;
  const std::int64_t num_columns = num_columns_before_row(row);
  lead_ += num_columns * column_lead_ - std::abs(row - cell_.row) * row_lead_;
  cell_ = {cell_.column + column_step_ * static_cast<std::int32_t>(num_columns), row};
}

}  // namespace setsquare
