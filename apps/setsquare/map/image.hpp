// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "apps/setsquare/map/run.hpp"
#include "setsquare/core/loop_closure.hpp"
#include "setsquare/drawing/image.hpp"
#include "setsquare/grid/occupancy_grid.hpp"

namespace setsquare::app {

/// The grid of a run, along the map's axes, without scans that were lost: they would smear walls
/// where nobody knows them to be.
[[nodiscard]] OccupancyGrid map_grid(const MapRun& run, int num_threads = 1);

/// The same along the building's walls, where the map's axes are others (the paper's preset).
[[nodiscard]] OccupancyGrid upright_map_grid(const MapRun& run, int num_threads = 1);

/// Whether somebody knows where in the map each scan lies: not those of pieces that were not
/// joined.
[[nodiscard]] std::vector<bool> scans_placed(const MappedTrack& track);

/// The closures of a track, accepted and refused.
[[nodiscard]] std::vector<LoopClosure> closures_of(const MappedTrack& track);

/// map.png of a run: a grid of it, the robot's path, what was degenerate or lost, loop closures.
[[nodiscard]] Image map_image(const MapRun& run, const OccupancyGrid& grid);

}  // namespace setsquare::app
