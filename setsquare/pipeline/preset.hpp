// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "setsquare/scan/match_result.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// How two scans are matched.
enum class Preset {
  kDefault,  ///< Propose, verify, refine, answer (matching/scan_matcher.hpp).
  kPaper,    ///< Bando et al. 2014 as printed (paper/paper_matcher.hpp).
};

/// "default" or "paper". Throws ParameterError.
[[nodiscard]] Preset preset_from(std::string_view name);

/// Prepares both scans from raw ranges and matches them; poses of the sensors.
[[nodiscard]] MatchResult match_by(Preset preset, const Scan& reference, const Scan& current);

}  // namespace setsquare
