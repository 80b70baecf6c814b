// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>
#include <string>

#include "setsquare/scan/match_result.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare::app {

/// How two scans are matched.
enum class Preset {
  kDefault,  ///< Propose, verify, refine, answer (matching/scan_matcher.hpp).
  kPaper,    ///< Bando et al. 2014 as printed (paper/paper_matcher.hpp).
};

/// Adds --preset default|paper. `preset` must outlive the application.
void add_preset_option(CLI::App& subcommand, Preset& preset);

/// Adds --frame base|sensor. `is_of_sensor` must outlive the application.
void add_frame_option(CLI::App& subcommand, bool& is_of_sensor);

/// Prepares both scans from raw ranges and matches them; poses of the sensors.
[[nodiscard]] MatchResult match_by(Preset preset, const Scan& reference, const Scan& current);

}  // namespace setsquare::app
