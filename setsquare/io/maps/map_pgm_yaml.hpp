// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "setsquare/grid/occupancy_grid.hpp"
#include "setsquare/io/maps/map_yaml.hpp"
#include "setsquare/io/maps/pgm_image.hpp"

namespace setsquare {

/// Reads a map as map_server (ROS) stores it: a yaml file and the PGM or PNG image that it names. Darker
/// is likelier occupied, p = (white - value) / white, or value / white where negated; p above the
/// occupied threshold is occupied, below the free threshold free, between them unknown (trinary) or
/// scaled (MapMode). Certain cells get a probability of 0.99 or 0.01. Throws FileError, FormatError
/// with line (yaml) or offset (image).
[[nodiscard]] OccupancyGrid read_map_pgm_yaml(const std::string& yaml_path);

/// The same from parts that are read already. Throws ParameterError (OccupancyGrid).
[[nodiscard]] OccupancyGrid grid_from_pgm_yaml(const PgmImage& image, const MapYaml& map);

/// The two files of a map, as bytes.
struct MapFiles {
  std::string pgm;
  std::string yaml;
};

/// A map as map_server's map_saver stores it and nav2 loads it: trinary, black (0) where occupied,
/// white (254) where free, grey (205) where unknown; a cell is occupied or free where its
/// probability passes the thresholds that stand in the yaml file (MapYaml's). `image_name` is the
/// image's name as written in the yaml file.
/// Throws ParameterError where the grid is turned against the map frame: nav2's and map_server's
/// clients do not look at an origin's yaw. Make the grid with grid_heading_rad 0.
[[nodiscard]] MapFiles map_files_from_grid(const OccupancyGrid& grid,
                                           const std::string& image_name = "map.pgm");

}  // namespace setsquare
