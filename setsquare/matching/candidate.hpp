// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/core/pose2.hpp"
#include "setsquare/matching/alignment.hpp"
#include "setsquare/matching/match_params.hpp"

namespace setsquare {

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

}  // namespace setsquare
