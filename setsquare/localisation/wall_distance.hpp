// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "setsquare/grid/occupancy_grid.hpp"

namespace setsquare {

/// How far the nearest wall of a grid is from each of its cells, up to kReach_m. Places are given
/// in metres in the grid's frame.
class WallDistance {
 public:
  static constexpr double kReach_m = 2.5;  ///< What is farther counts as this far.

  /// Of all cells of a grid.
  explicit WallDistance(const OccupancyGrid& grid);

  /// Side of a cell, as the grid's.
  [[nodiscard]] double resolution_m() const { return resolution_m_; }
  /// As the grid's.
  [[nodiscard]] std::int32_t num_columns() const { return num_columns_; }
  /// As the grid's.
  [[nodiscard]] std::int32_t num_rows() const { return num_rows_; }
  /// Whether the grid has the cell.
  [[nodiscard]] bool contains(CellIndex cell) const {
    return cell.column >= 0 && cell.row >= 0 && cell.column < num_columns_ && cell.row < num_rows_;
  }
  /// What the grid has there; unknown outside it.
  [[nodiscard]] CellState state(CellIndex cell) const {
    return contains(cell) ? state_inside(cell) : CellState::kUnknown;
  }
  /// The same of a cell that the grid has.
  [[nodiscard]] CellState state_inside(CellIndex cell) const { return states_[index(cell)]; }
  /// The cell of a place, inside the grid or not.
  [[nodiscard]] CellIndex cell_at(double x_m, double y_m) const;

  /// From the middle of a cell inside the grid to that of the nearest wall's cell, within 1 cm.
  [[nodiscard]] float distance_m(CellIndex cell) const {
    return kUnit_m * static_cast<float>(distance_[index(cell)]);
  }

  /// The distance at a place, and how it changes along x and y.
  struct Slope {
    float distance_m = static_cast<float>(kReach_m);  ///< To the nearest wall.
    float along_x = 0.0F;                             ///< Change per metre along x.
    float along_y = 0.0F;                             ///< The same along y.
  };
  /// Between the four cells about the place, linearly; far from everything outside the grid.
  [[nodiscard]] Slope slope_at(float x_m, float y_m) const;

 private:
  static constexpr float kUnit_m = 0.01F;

  [[nodiscard]] std::size_t index(CellIndex cell) const {
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(num_columns_) +
           static_cast<std::size_t>(cell.column);
  }

  double resolution_m_;
  std::int32_t num_columns_;
  std::int32_t num_rows_;
  std::vector<CellState> states_;
  std::vector<std::uint8_t> distance_;  ///< In kUnit_m.
};

}  // namespace setsquare
