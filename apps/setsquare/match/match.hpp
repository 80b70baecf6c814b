// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The two ways of `setsquare match`: two scans, or the pairs of a relations file.
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

struct MatchPairsOptions {
  std::string log_path;
  LogOptions log;
  std::string relations_path;
  std::string output_path;  ///< "-" for standard output.
  Preset preset = Preset::kDefault;
};

/// Matches the two scans of every relation, from raw ranges each time. Writes a table with one line
/// per relation, and to standard error a summary against the relations.
void match_pairs(const MatchPairsOptions& options);

}  // namespace setsquare::app
