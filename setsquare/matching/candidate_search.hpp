// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "setsquare/matching/candidate.hpp"
#include "setsquare/matching/correlation_grid.hpp"
#include "setsquare/matching/match_trace.hpp"
#include "setsquare/matching/prepared_scan.hpp"

namespace setsquare {

/// Proposes, verifies, refines:
///
/// 1. every translation of the window is correlated at each rotation, the best local maxima kept;
/// 2. each is refined and scored with a few samples, both ways;
/// 3. the best different ones are refined and scored with all samples.
///
/// Returns those of step 3, best first. `trace`, if any, receives all that were refined.
[[nodiscard]] std::vector<Candidate> search_candidates(const PreparedScan& reference,
                                                       const PreparedScan& current,
                                                       const CorrelationGrid& grid,
                                                       std::span<const RotationProposal> rotations,
                                                       const SearchParams& search,
                                                       const MatchParams& params,
                                                       MatchTrace* trace);

}  // namespace setsquare
