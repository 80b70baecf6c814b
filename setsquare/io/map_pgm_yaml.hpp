// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "setsquare/grid/occupancy_grid.hpp"
#include "setsquare/io/map_yaml.hpp"
#include "setsquare/io/pgm_image.hpp"

namespace setsquare {

/// Reads a map as map_server (ROS) stores it: a yaml file and the PGM image that it names. Darker
/// is likelier occupied, p = (white - value) / white, or value / white where negated; p above the
/// occupied threshold is occupied, below the free threshold free, between them unknown (trinary) or
/// scaled (MapMode). Certain cells get a probability of 0.99 or 0.01. Throws FileError, FormatError
/// with line (yaml) or offset (image).
[[nodiscard]] OccupancyGrid read_map_pgm_yaml(const std::string& yaml_path);

/// The same from parts that are read already. Throws ParameterError (OccupancyGrid).
[[nodiscard]] OccupancyGrid grid_from_pgm_yaml(const PgmImage& image, const MapYaml& map);

}  // namespace setsquare
