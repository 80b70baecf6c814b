// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/report/palette.hpp"
#include "setsquare/scan/match_result.hpp"

namespace setsquare {

/// Green for an answer that stands, red for none, amber for an open one.
[[nodiscard]] constexpr Color status_color(MatchStatus status) {
  switch (status) {
    case MatchStatus::kMatched:
      return palette::kAnswer;
    case MatchStatus::kAmbiguous:
    case MatchStatus::kDegenerate:
      return color(0xb26a00);
    default:
      return palette::kLost;
  }
}

}  // namespace setsquare
