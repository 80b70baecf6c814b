// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/scan/match_result.hpp"

namespace setsquare {

std::string_view to_string(MatchStatus status) {
  switch (status) {
    case MatchStatus::kMatched:
      return "matched";
    case MatchStatus::kAmbiguous:
      return "ambiguous";
    case MatchStatus::kDegenerate:
      return "degenerate";
    case MatchStatus::kNoOverlap:
      return "no_overlap";
    case MatchStatus::kTooFewPoints:
      return "too_few_points";
    case MatchStatus::kRejected:
      return "rejected";
  }
  return "unknown";
}

}  // namespace setsquare
