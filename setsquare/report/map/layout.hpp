// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "setsquare/core/trajectory.hpp"
#include "setsquare/grid/occupancy_grid.hpp"
#include "setsquare/report/map/raster.hpp"

namespace setsquare {

/// Where everything lies in a map picture: the map above, in the middle of the width, and below it
/// a footer of five letters' height, if there is one.
struct MapLayout {
  CellBox box;
  MapScale scale;
  int map_width_px = 0;
  int map_height_px = 0;
  double letter_px = 0.0;  ///< Height of a capital letter; the unit of all that is not the map.
  int width_px = 0;
  int height_px = 0;
  int left_px = 0;  ///< Of the map; its top is 0.

  /// Makes the picture wide enough for a footer of this width and adds the footer's height.
  void add_footer(double footer_width_px);
  /// Pixel of a place given in cells from the grid's lower left corner.
  [[nodiscard]] Eigen::Vector2d pixel_of(const Eigen::Vector2d& place_cells) const;
};

/// The layout of a picture without footer of the cells of `box`.
[[nodiscard]] MapLayout map_layout(const CellBox& box, int min_side_px, int max_side_px);

/// The walls of the grid and the path within it, with a margin.
[[nodiscard]] CellBox box_to_show(const OccupancyGrid& grid,
                                  std::span<const Eigen::Vector2d> path_cells,
                                  double margin_m);

/// The poses' places in cells from the grid's lower left corner.
[[nodiscard]] std::vector<Eigen::Vector2d> path_in_cells(const OccupancyGrid& grid,
                                                         std::span<const StampedPose> T_map_base);

}  // namespace setsquare
