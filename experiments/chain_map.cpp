// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/chain_map.hpp"

#include <vector>

#include "setsquare/drawing/png.hpp"
#include "setsquare/grid/grid_from_scans.hpp"
#include "setsquare/report/map/picture.hpp"

namespace setsquare::experiments {

std::string map_png(std::span<const SimulatedScan> scans,
                    std::span<const Pose2> T_map_base,
                    double axis_rad) {
  std::vector<PlacedScan> placed;
  Trajectory trajectory;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    placed.push_back({&scans[k].scan, T_map_base[k] * scans[k].scan.T_base_sensor});
    trajectory.push_back({scans[k].scan.stamp, T_map_base[k]});
  }
  // Enough for a picture a screen wide.
  const GridFromScansParams grid{.resolution_m = 0.1, .min_spacing_m = 0.7, .min_turn_rad = 0.5};
  const MapPictureParams picture{.max_side_px = 1300};
  return png_from_image(
      map_picture(grid_from_scans(placed, axis_rad, grid), trajectory, picture));
}

}  // namespace setsquare::experiments
