// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// A cell of a grid: column along the grid's x, row along its y, from the lower left corner.
struct CellIndex {
  std::int32_t column = 0;  ///< Along the grid's x axis, from 0 at its left edge.
  std::int32_t row = 0;     ///< Along the grid's y axis, from 0 at its lower edge.

  /// By column, then by row.
  auto operator<=>(const CellIndex&) const = default;
};

/// What a cell is known to be.
enum class CellState {
  kUnknown,   ///< Nothing was seen there, or as much for as against.
  kFree,      ///< Beams passed through it.
  kOccupied,  ///< Beams ended in it.
};

/// Log-odds occupancy of square cells. The grid has its own frame, whose origin is the lower
/// left corner of cell (0, 0) and whose axes run along rows and columns: a grid may lie at an angle
/// in the map, for example along a building's walls.
class OccupancyGrid {
 public:
  /// `T_map_grid` is the pose of the lower left corner. Throws ParameterError where the resolution
  /// or a number of cells is not positive, or there would be more than kMaxCells.
  OccupancyGrid(const Pose2& T_map_grid,
                double resolution_m,
                std::int32_t num_columns,
                std::int32_t num_rows);

  /// That a grid may have: 1.6 GB.
  static constexpr std::int64_t kMaxCells = 400'000'000;

  /// Pose of the grid, its lower left corner, in the map frame.
  [[nodiscard]] const Pose2& T_map_grid() const { return T_map_grid_; }
  /// Side of a cell, in m.
  [[nodiscard]] double resolution_m() const { return resolution_m_; }
  /// Cells along the grid's x axis.
  [[nodiscard]] std::int32_t num_columns() const { return num_columns_; }
  /// Cells along the grid's y axis.
  [[nodiscard]] std::int32_t num_rows() const { return num_rows_; }
  /// Whether the cell lies in the grid.
  [[nodiscard]] bool contains(CellIndex cell) const {
    return cell.column >= 0 && cell.row >= 0 && cell.column < num_columns_ && cell.row < num_rows_;
  }

  /// Logarithm of the odds that a cell is occupied; 0 where nothing is known.
  [[nodiscard]] float log_odds(CellIndex cell) const { return log_odds_[index(cell)]; }
  /// Probability that a cell is occupied, 0.5 where nothing is known.
  [[nodiscard]] double probability(CellIndex cell) const;
  /// Occupied above a probability of 0.5, free below it, unknown where it is exactly that.
  [[nodiscard]] CellState state(CellIndex cell) const {
    const float value = log_odds(cell);
    return value > 0.0F   ? CellState::kOccupied
           : value < 0.0F ? CellState::kFree
                          : CellState::kUnknown;
  }

  /// Position of a cell in `values`: row by row from the lowest.
  [[nodiscard]] std::size_t index(CellIndex cell) const {
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(num_columns_) +
           static_cast<std::size_t>(cell.column);
  }
  /// The log-odds of all cells, row by row from the lowest: see index().
  [[nodiscard]] const std::vector<float>& values() const { return log_odds_; }
  /// The same, to write.
  [[nodiscard]] std::vector<float>& values() { return log_odds_; }

 private:
  Pose2 T_map_grid_;
  double resolution_m_;
  std::int32_t num_columns_;
  std::int32_t num_rows_;
  std::vector<float> log_odds_;
};

}  // namespace setsquare
