// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "setsquare/core/relation.hpp"
#include "setsquare/io/tables/relations.hpp"
#include "setsquare/scan/match_result.hpp"

namespace setsquare::app {

struct PairOutcome {
  MatchResult result;       ///< Poses of the robot.
  double elapsed_us = 0.0;  ///< Preparing both scans from raw ranges, and the match.
};

/// How matches stand against relations, as a table for a person: success (0.2 m and 30 deg), tight
/// (0.05 m and 1 deg), matched, wrong among the matched (over 0.2 m or 3 deg), median errors and
/// time; by overlap where overlaps are given (one a relation, else none).
[[nodiscard]] std::string match_summary(const std::vector<Relation>& relations,
                                        const std::vector<PairOverlap>& overlaps,
                                        const std::vector<PairOutcome>& outcomes);

}  // namespace setsquare::app
