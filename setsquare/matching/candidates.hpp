// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/matching/match_params.hpp"
#include "setsquare/surfaces/alignment.hpp"
#include "setsquare/surfaces/correlation_grid.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {

struct MatchTrace;

/// A relative pose on its way from proposal to answer.
struct Candidate {
  Pose2 T_proposed = {};  ///< As the correlation proposed it.
  int correlation = 0;
  Pose2 T_reference_current = {};  ///< As refined so far.
  Evidence evidence = {};
  double score = 0.0;
};

/// Agreement less hidden returns and contradictions (ScoreParams), as shares of the compared wall:
/// at most 1, and 1 only where everything agrees to the millimetre.
[[nodiscard]] double score(const Evidence& evidence, const ScoreParams& params);

/// Whether two poses are one answer, within the size of one basin.
[[nodiscard]] bool are_same(const Pose2& a, const Pose2& b, const AnswerParams& params);

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
