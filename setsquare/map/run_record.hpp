// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "setsquare/core/version.hpp"

namespace setsquare {

/// How a map was made: what run.json tells, apart from the map itself. Texts may be empty; two of
/// the JSON texts are objects, the findings an array.
struct RunRecord {
  std::string version = setsquare::version();               ///< Of the Setsquare that made the map.
  std::string log = {};                                     ///< As the user named it.
  std::string format = {};                                  ///< Of the log.
  std::string sensor = {};                                  ///< The laser's name, or "all".
  std::map<std::uint32_t, std::string> scanner_names = {};  ///< Of Map::scanners, by number.
  std::string preset = "default";                           ///< "default" or "paper".
  std::string options_json = "{}";        ///< The command's, which decide the map.
  std::string parameters_json = "{}";     ///< Of the preset, each of them.
  std::string findings_json = "[]";       ///< What is wrong with the log.
  std::uint64_t num_damaged_records = 0;  ///< Skipped by the reader.
};

}  // namespace setsquare
