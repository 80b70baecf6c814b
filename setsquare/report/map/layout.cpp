// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/layout.hpp"

#include <algorithm>
#include <cmath>

namespace setsquare {

void MapLayout::add_footer(double footer_width_px) {
  width_px = std::max(map_width_px, static_cast<int>(std::ceil(footer_width_px)));
  left_px = (width_px - map_width_px) / 2;
  height_px = map_height_px + static_cast<int>(5.0 * letter_px);
}

Eigen::Vector2d MapLayout::pixel_of(const Eigen::Vector2d& place_cells) const {
  const double pixels_per_cell = scale.pixels_per_cell();
  return {left_px + (place_cells.x() - box.begin.column) * pixels_per_cell,
          (box.end.row - place_cells.y()) * pixels_per_cell};
}

MapLayout map_layout(const CellBox& box, int min_side_px, int max_side_px) {
  MapLayout layout;
  layout.box = box;
  layout.scale = map_scale(box, min_side_px, max_side_px);
  const auto pixels = [&layout](std::int32_t num_cells) {
    const std::int32_t n = layout.scale.cells_per_block;
    return (num_cells + n - 1) / n * layout.scale.pixels_per_block;
  };
  layout.map_width_px = layout.width_px = pixels(box.num_columns());
  layout.map_height_px = layout.height_px = pixels(box.num_rows());
  constexpr double kLettersAcross = 90.0;
  const double longer_px = std::max(layout.map_width_px, layout.map_height_px);
  layout.letter_px = std::clamp(longer_px / kLettersAcross, 9.0, 30.0);
  return layout;
}

CellBox box_to_show(const OccupancyGrid& grid,
                    std::span<const Eigen::Vector2d> path_cells,
                    double margin_m) {
  CellBox box = box_of_walls(grid);
  for (const Eigen::Vector2d& place : path_cells) {
    const bool is_in_grid = place.x() >= 0.0 && place.y() >= 0.0 &&
                            place.x() < grid.num_columns() && place.y() < grid.num_rows();
    if (!is_in_grid) continue;
    const auto column = static_cast<std::int32_t>(place.x());
    const auto row = static_cast<std::int32_t>(place.y());
    box.begin = {std::min(box.begin.column, column), std::min(box.begin.row, row)};
    box.end = {std::max(box.end.column, column + 1), std::max(box.end.row, row + 1)};
  }
  const auto margin = static_cast<std::int32_t>(std::lround(margin_m / grid.resolution_m()));
  return {{box.begin.column - margin, box.begin.row - margin},
          {box.end.column + margin, box.end.row + margin}};
}

std::vector<Eigen::Vector2d> path_in_cells(const OccupancyGrid& grid,
                                           std::span<const StampedPose> T_map_base) {
  const Pose2 T_grid_map = grid.T_map_grid().inverse();
  std::vector<Eigen::Vector2d> path;
  path.reserve(T_map_base.size());
  for (const StampedPose& stamped : T_map_base) {
    path.emplace_back(T_grid_map * stamped.pose.translation() / grid.resolution_m());
  }
  return path;
}

}  // namespace setsquare
