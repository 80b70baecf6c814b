// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "apps/setsquare/preset.hpp"
#include "setsquare/io/logs/log_reader.hpp"

namespace setsquare::app {

struct MatchOneOptions {
  std::string log_path;
  LogOptions log;
  std::vector<std::string> scans;  ///< Two: indices or stamps.
  Preset preset = Preset::kDefault;
  bool is_of_sensor = false;
  bool is_json = false;
};

/// Matches two scans of a log and prints the answer with its evidence.
void match_one(const MatchOneOptions& options);

}  // namespace setsquare::app
