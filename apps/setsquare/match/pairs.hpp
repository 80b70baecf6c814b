// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "apps/setsquare/preset.hpp"
#include "setsquare/io/logs/log_reader.hpp"

namespace setsquare::app {

struct MatchPairsOptions {
  std::string log_path;
  LogOptions log;
  std::string relations_path;
  std::string output_path;  ///< "-" for standard output.
  Preset preset = Preset::kDefault;
};

/// Matches the two scans of every relation, from raw ranges each time, writes one tab-separated
/// line a relation and a summary against the relations to standard error.
void match_pairs(const MatchPairsOptions& options);

}  // namespace setsquare::app
