// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "setsquare/grid/occupancy_grid.hpp"
#include "setsquare/pipeline/localize_log.hpp"

namespace setsquare::app {

/// The files that `setsquare localize` writes.
[[nodiscard]] std::vector<std::string> localize_output_names();

/// A file's name and bytes.
using NamedBytes = std::pair<std::string, std::string>;

/// trajectory.tum (of the scans that were localised), localisation.tsv (a row per scan that has a
/// pose), localisation.png (the map and the way) and run.json.
[[nodiscard]] std::vector<NamedBytes> localize_outputs(const LocalizedLog& log,
                                                       const OccupancyGrid& grid,
                                                       const std::string& map_name,
                                                       PoseOf pose_of);

}  // namespace setsquare::app
