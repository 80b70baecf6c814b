// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "apps/setsquare/map_run.hpp"

namespace setsquare::app {

/// Draws map.png of a run: the grid along the building's walls, the robot's path, what was
/// degenerate or lost. Throws FileError.
void save_map_image(const MapRun& run, const std::string& path);

}  // namespace setsquare::app
