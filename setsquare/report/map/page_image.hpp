// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "setsquare/drawing/image.hpp"
#include "setsquare/grid/occupancy_grid.hpp"

namespace setsquare {

/// The known part of a grid as a grey picture. Shades state what the cells are, not their colours:
/// 0 surely occupied, 128 unknown, 255 surely free; the page chooses the colours.
struct MapReportImage {
  Image image;
  double pixel_m = 0.0;  ///< Side of a pixel.
  // The picture's lower left corner in the grid's frame.
  double left_m = 0.0;
  double bottom_m = 0.0;
};

/// Cells are joined where a side would be longer than max_side_px. Nothing where no cell is known.
[[nodiscard]] std::optional<MapReportImage> map_report_image(const OccupancyGrid& grid,
                                                             int max_side_px = 4000);

}  // namespace setsquare
