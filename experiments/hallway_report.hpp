// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiments/hallway_study.hpp"
#include "experiments/json.hpp"

namespace setsquare::experiments {

/// Aggregates of the first hallway and of all, and every pair of the first; no times.
[[nodiscard]] Json json_from(const HallwayStudy& study);
[[nodiscard]] Json json_from(const MatchTimes& times);
[[nodiscard]] std::string hallway_html(const HallwayStudy& study);
/// A few lines for a terminal.
[[nodiscard]] std::string hallway_text(const HallwayStudy& study);

}  // namespace setsquare::experiments
