// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "setsquare/map/map.hpp"

namespace setsquare {

/// How a map was made: the contents of run.json, apart from the map itself. Texts may be empty; two
/// of the JSON texts are objects, the findings an array.
struct RunRecord {
  std::string log = {};     ///< As the user named it.
  std::string format = {};  ///< Of the log.
  std::string sensor = {};
  std::map<std::uint32_t, std::string> scanner_names = {};  ///< Of Map::scanners, by number.
  std::string preset = "default";
  std::string options_json = "{}";
  std::string parameters_json = "{}";
  std::string findings_json = "[]";  ///< What is wrong with the log.
  std::uint64_t num_damaged_records = 0;
};

/// The content of run.json: what was read, how it went, with which options and parameters. The
/// same map and record give the same bytes; times are in timing.json. `changes`: of the map's grid
/// (occupancy_grid_with_changes). Throws ParameterError where a
/// JSON text of the record is not what it should be.
[[nodiscard]] std::string run_json(const Map& map,
                                   const RunRecord& run,
                                   PoseOf pose_of,
                                   std::span<const ChangedPlace> changes = {});

}  // namespace setsquare
