// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/page_image.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "setsquare/report/map/raster.hpp"

namespace setsquare {
namespace {

/// The smallest box with every cell of which something is known; empty where there is none.
CellBox box_of_known(const OccupancyGrid& grid) {
  CellBox box = {{grid.num_columns(), grid.num_rows()}, {0, 0}};
  for (CellIndex cell; cell.row < grid.num_rows(); ++cell.row) {
    for (cell.column = 0; cell.column < grid.num_columns(); ++cell.column) {
      if (grid.state(cell) == CellState::kUnknown) continue;
      box.begin.column = std::min(box.begin.column, cell.column);
      box.begin.row = std::min(box.begin.row, cell.row);
      box.end.column = std::max(box.end.column, cell.column + 1);
      box.end.row = std::max(box.end.row, cell.row + 1);
    }
  }
  return box;
}

/// Few shades, so that the file is small.
std::uint8_t shade_of(float log_odds) {
  constexpr double kSureOccupied = 1.5;
  constexpr double kSureFree = -1.0;
  constexpr double kNumShades = 4.0;  // On either side of unknown.
  const double share = std::min(log_odds / (log_odds > 0.0F ? kSureOccupied : kSureFree), 1.0);
  const double steps = std::ceil(share * kNumShades) / kNumShades;
  return static_cast<std::uint8_t>(
      std::lround(log_odds > 0.0F ? 128 - 128 * steps : 128 + 127 * steps));
}

}  // namespace

std::optional<MapReportImage> map_report_image(const OccupancyGrid& grid, int max_side_px) {
  const CellBox box = box_of_known(grid);
  if (box.num_columns() <= 0) return std::nullopt;
  const std::int32_t n = map_scale(box, 1, max_side_px).cells_per_block;
  const int width_px = (box.num_columns() + n - 1) / n;
  const int height_px = (box.num_rows() + n - 1) / n;
  MapReportImage map = {Image(width_px, height_px, {128, 128, 128}),
                        n * grid.resolution_m(),
                        box.begin.column * grid.resolution_m(),
                        box.begin.row * grid.resolution_m()};
  for (int row = 0; row < height_px; ++row) {
    const std::int32_t cell_row = box.begin.row + (height_px - 1 - row) * n;
    for (int column = 0; column < width_px; ++column) {
      const CellIndex first = {box.begin.column + column * n, cell_row};
      const std::uint8_t shade = shade_of(log_odds_of_block(grid, first, n));
      map.image.set(column, row, {shade, shade, shade});
    }
  }
  return map;
}

}  // namespace setsquare
