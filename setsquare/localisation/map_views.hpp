// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/grid/placed_scan.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {

/// What a scan of the map's own saw where it was taken.
struct MapView {
  Pose2 T_grid_sensor;  ///< Of its sensor, in the frame of the grid.
  SurfaceImage image;   ///< Its surfaces.
  SurfaceSamples fine;  ///< Its samples, as PreparedScan::fine.
};

/// Of placed scans, in a grid's frame. Any number of threads gives the same.
[[nodiscard]] std::vector<MapView> map_views(std::span<const PlacedScan> scans,
                                             const Pose2& T_map_grid,
                                             std::size_t num_threads = 1);

/// How a scan at a place falls on what the views about the place saw. All views together: a piece
/// of wall that one of them saw is seen, and one through which one looked, and that none saw, is
/// not there.
struct SeenByViews {
  std::size_t num_views = 0;  ///< That looked there; 0: the views tell nothing of the place.
  double wall_m = 0.0;        ///< Of the scan.
  double tight_m = 0.0;       ///< Of it on a wall of some view to 4 cm, facing the same way ...
  double loose_m = 0.0;       ///< ... and to 15 cm.
  double through_m = 0.0;     ///< On none, and some view looked through it.
  double behind_m = 0.0;      ///< On none, through none, behind what some view saw.
  double outside_m = 0.0;     ///< Where none looked.
  double distance_m = 0.0;    ///< Of what is loose from its wall (root of the mean square).
  // Of the walls of the views that agree most, per view:
  double missed_m = 0.0;       ///< The scan looked through them.
  double unexplained_m = 0.0;  ///< They lie behind something that is not on a wall of the view.
};

/// Lays the scan onto the views about the place, at most the 80 nearest, and compares.
[[nodiscard]] SeenByViews seen_by_views(std::span<const MapView> views,
                                        const PreparedScan& scan,
                                        const Pose2& T_grid_sensor);

}  // namespace setsquare
