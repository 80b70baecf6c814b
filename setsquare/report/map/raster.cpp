// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/raster.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "setsquare/report/palette.hpp"

namespace setsquare {
namespace {

/// The interval, end exclusive, left when a thousandth of the counts is cut off at each side.
std::pair<std::int32_t, std::int32_t> trimmed(const std::vector<std::int64_t>& counts,
                                              std::int64_t total) {
  const std::int64_t num_cut = total / 1000;
  std::size_t begin = 0;
  std::size_t end = counts.size();
  for (std::int64_t cut = counts[begin]; cut <= num_cut; cut += counts[begin]) ++begin;
  for (std::int64_t cut = counts[end - 1]; cut <= num_cut; cut += counts[end - 1]) --end;
  return {static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end)};
}

Color color_of(float log_odds) {
  constexpr double kSureOccupied = 1.5;
  constexpr double kSureFree = -1.0;
  const Color extreme = log_odds > 0.0F ? palette::kWall : palette::kFree;
  const double share = log_odds / (log_odds > 0.0F ? kSureOccupied : kSureFree);
  return mix(palette::kUnknown, extreme, std::min(share, 1.0));
}

}  // namespace

MapScale map_scale(const CellBox& box, int min_side_px, int max_side_px) {
  const std::int32_t side_cells = std::max(box.num_columns(), box.num_rows());
  MapScale scale;
  scale.cells_per_block = (side_cells + max_side_px - 1) / max_side_px;
  constexpr std::int32_t kMaxEnlargement = 4;
  while (scale.pixels_per_block < kMaxEnlargement &&
         side_cells * scale.pixels_per_block < min_side_px &&
         side_cells * (scale.pixels_per_block + 1) <= max_side_px) {
    ++scale.pixels_per_block;
  }
  return scale;
}

CellBox box_of_walls(const OccupancyGrid& grid) {
  std::vector<std::int64_t> in_column(static_cast<std::size_t>(grid.num_columns()), 0);
  std::vector<std::int64_t> in_row(static_cast<std::size_t>(grid.num_rows()), 0);
  std::int64_t total = 0;
  for (CellIndex cell; cell.row < grid.num_rows(); ++cell.row) {
    for (cell.column = 0; cell.column < grid.num_columns(); ++cell.column) {
      if (grid.state(cell) != CellState::kOccupied) continue;
      ++in_column[static_cast<std::size_t>(cell.column)];
      ++in_row[static_cast<std::size_t>(cell.row)];
      ++total;
    }
  }
  if (total == 0) return {{0, 0}, {grid.num_columns(), grid.num_rows()}};
  const auto [first_column, end_column] = trimmed(in_column, total);
  const auto [first_row, end_row] = trimmed(in_row, total);
  return {{first_column, first_row}, {end_column, end_row}};
}

float log_odds_of_block(const OccupancyGrid& grid, CellIndex first, std::int32_t num_cells) {
  float highest = 0.0F;
  float lowest = 0.0F;
  for (std::int32_t row = first.row; row < first.row + num_cells; ++row) {
    for (std::int32_t column = first.column; column < first.column + num_cells; ++column) {
      if (!grid.contains({column, row})) continue;
      const float value = grid.log_odds({column, row});
      highest = std::max(highest, value);
      lowest = std::min(lowest, value);
    }
  }
  return highest > 0.0F ? highest : lowest;
}

void draw_cells(Image& image,
                int left_px,
                int top_px,
                const OccupancyGrid& grid,
                const CellBox& box,
                const MapScale& scale) {
  const std::int32_t n = scale.cells_per_block;
  const std::int32_t size_px = scale.pixels_per_block;
  int top = top_px;
  for (std::int32_t row = box.end.row - n; row > box.begin.row - n; row -= n, top += size_px) {
    int left = left_px;
    for (std::int32_t column = box.begin.column; column < box.end.column;
         column += n, left += size_px) {
      const Color value = color_of(log_odds_of_block(grid, {column, row}, n));
      for (int y = top; y < top + size_px; ++y) {
        for (int x = left; x < left + size_px; ++x) {
          if (image.contains(x, y)) image.set(x, y, value);
        }
      }
    }
  }
}

}  // namespace setsquare
