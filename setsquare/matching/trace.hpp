// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "setsquare/matching/candidates.hpp"
#include "setsquare/matching/probability.hpp"
#include "setsquare/matching/verdict.hpp"
#include "setsquare/surfaces/angle_histogram.hpp"

namespace setsquare {

/// How far a proposal came.
enum class CandidateFate {
  kAnswer,        ///< The best.
  kRunnerUp,      ///< The best that differs from the answer.
  kOutscored,     ///< Refined with all samples, and worse.
  kSameAsBetter,  ///< Fell into the basin of a better one.
  kDroppedEarly,  ///< Outscored on a few samples already.
};

struct TracedCandidate {
  Candidate candidate;
  CandidateFate fate = CandidateFate::kDroppedEarly;
};

/// What the verdict measured at the answer.
struct TracedVerdict {
  WallConstraint constraint;
  TwoWayEvidence two_way;
  double distinct_wall_m = 0.0;
  double min_distinct_m = 0.0;  ///< Asked of it: more of the quick search than of the thorough one.
  ProbabilityEvidence probability;
  std::optional<double> place_log_odds;  ///< Nothing where it was not asked.
  std::vector<Pose2> aliases;            ///< In the reference's frame.
};

/// What one match considered, for `explain`. Poses are those of the sensors.
struct MatchTrace {
  std::vector<RotationProposal> rotations;  ///< Of the quick search.
  std::vector<TracedCandidate> candidates;  ///< Best first, of the last search that ran.
  bool was_thorough = false;                ///< Whether every rotation of the circle was tried.
  std::optional<TracedVerdict> verdict;     ///< Of the last search; nothing without a candidate.
};

}  // namespace setsquare
