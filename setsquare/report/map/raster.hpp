// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "setsquare/core/pose2.hpp"
#include "setsquare/drawing/image.hpp"
#include "setsquare/grid/occupancy_grid.hpp"

namespace setsquare {

/// A rectangle of cells, end exclusive.
struct CellBox {
  CellIndex begin;
  CellIndex end;

  [[nodiscard]] std::int32_t num_columns() const { return end.column - begin.column; }
  [[nodiscard]] std::int32_t num_rows() const { return end.row - begin.row; }
};

/// How cells become pixels: blocks of `cells_per_block` x `cells_per_block` cells are joined, each
/// block is drawn as `pixels_per_block` x `pixels_per_block` pixels. One of the two is 1.
struct MapScale {
  std::int32_t cells_per_block = 1;
  std::int32_t pixels_per_block = 1;

  [[nodiscard]] double pixels_per_cell() const {
    return static_cast<double>(pixels_per_block) / cells_per_block;
  }
};

/// The largest scale at which the box's longer side has at most `max_side_px` pixels; cells are
/// enlarged, up to fourfold, only while it has fewer than `min_side_px`.
[[nodiscard]] MapScale map_scale(const CellBox& box, int min_side_px, int max_side_px);

/// The smallest box with all occupied cells but the outermost 0.1 % on each side (single returns
/// through windows), or the whole grid where no cell is occupied.
[[nodiscard]] CellBox box_of_walls(const OccupancyGrid& grid);

/// Log-odds of the most occupied cell of the block of num_cells x num_cells cells from `first` up,
/// else of its freest; 0 where none is known.
[[nodiscard]] float log_odds_of_block(const OccupancyGrid& grid,
                                      CellIndex first,
                                      std::int32_t num_cells);

/// Draws the cells of the box (which may reach beyond the grid: unknown) with the box's upper left
/// corner at the pixel (left, top). A block shows its most occupied cell, else its freest.
void draw_cells(Image& image,
                int left_px,
                int top_px,
                const OccupancyGrid& grid,
                const CellBox& box,
                const MapScale& scale);

}  // namespace setsquare
