// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// How an image's grey becomes occupancy, as map_server names it.
enum class MapMode {
  kTrinary,  ///< Free, occupied or unknown, by the thresholds.
  kScale,    ///< Between the thresholds a probability from 0 to 1.
  kRaw,      ///< The value is the occupancy in percent; above 100 unknown.
};

/// Contents of the yaml file of a map's image (map_server's format).
struct MapYaml {
  std::string image;  ///< Path as written: relative to the yaml file's folder, or absolute.
  double resolution_m = 0.0;
  Pose2 T_map_grid;         ///< "origin": pose of the image's lower left corner, yaw included.
  bool is_negated = false;  ///< White is occupied instead of free.
  double occupied_threshold = 0.65;
  double free_threshold = 0.196;
  MapMode mode = MapMode::kTrinary;
};

/// Reads such a file's text. image, resolution (0.0001 to 1000 m) and origin must be there; what
/// else is missing is as above. Throws FormatError with the line. `name` stands in messages for the
/// path.
[[nodiscard]] MapYaml map_yaml_from_text(const std::string& text, const std::string& name);

/// The text of such a file: every entry, numbers with the fewest digits that give them back.
/// Throws ParameterError where map_yaml_from_text would not read it back.
[[nodiscard]] std::string text_from_map_yaml(const MapYaml& map);

}  // namespace setsquare
