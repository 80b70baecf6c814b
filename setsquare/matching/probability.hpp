// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from answer: tests and the fit (benchmarks/match_probability) look at it alone.
#pragma once

#include <array>
#include <cstddef>

#include "setsquare/matching/verdict.hpp"
#include "setsquare/matching/wall_kinds.hpp"

namespace setsquare {

/// What the probability of an answer is computed from.
struct ProbabilityEvidence {
  WallKinds kinds;  ///< Of both scans, summed.
  WallConstraint constraint;
  double score = 0.0;
  double margin = 0.0;         ///< Above the best different pose, or AnswerParams::floor_score.
  double one_way_share = 0.0;  ///< Of the judged wall of one scan, what the other contradicts.
  double distinct_wall_m = 0.0;
};

inline constexpr std::size_t kNumProbabilityFeatures = 14;
using ProbabilityFeatures = std::array<double, kNumProbabilityFeatures>;

/// The evidence as the numbers that the log odds are a weighted sum of.
[[nodiscard]] ProbabilityFeatures probability_features(const ProbabilityEvidence& evidence);

/// A probability is that of two scans that were taken so near to each other, however turned.
inline constexpr double kProbabilityWithin_m = 5.0;

/// Probability that the answer is right (within 0.2 m and 3 deg), of two scans from within
/// kProbabilityWithin_m of each other in one building of whose places nothing is known.
/// `num_aliases` other poses look the same: each is as probable as the answer.
[[nodiscard]] double match_probability(const ProbabilityEvidence& evidence,
                                       std::size_t num_aliases = 0);

/// The log odds after the monotone map: `log_odds` as the weighted sum gives them.
[[nodiscard]] double calibrated_log_odds(double log_odds);

/// The weighted sum alone.
[[nodiscard]] double log_odds_of(const ProbabilityFeatures& features);

}  // namespace setsquare
