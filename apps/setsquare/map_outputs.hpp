// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "apps/setsquare/output_set.hpp"
#include "setsquare/drawing/image.hpp"
#include "setsquare/grid/occupancy_grid.hpp"

namespace setsquare::app {

/// Every file that `setsquare map` may write, as OutputSet wants them: in the order in which they
/// come, run.json last, so that who finds it finds a whole set. docs/formats.md describes each.
[[nodiscard]] std::vector<std::string> map_output_names();

/// Adds map.pgm and map.yaml. Throws FileError; ParameterError where the grid is turned.
void add_map_files(OutputSet& outputs, const OccupancyGrid& grid);

/// Adds map.png. Throws FileError.
void add_map_picture(OutputSet& outputs, const Image& picture);

}  // namespace setsquare::app
