// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/probability.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace setsquare {
namespace {

/// Metres of wall beyond which a metre more tells less and less. A piece of 25 cm that contradicts
/// tells much; so does the first metre that agrees.
double pieces(double length_m, double unit_m) {
  return std::log1p(std::max(0.0, length_m) / unit_m);
}

constexpr double kPiece_m = 0.25;
/// Keeps shares of next to no wall near zero.
constexpr double kLittle_m = 0.5;

// The figures below are those that `match_probability fit` prints (benchmarks/match_probability):
// logistic regression over 61806 best answers in simulated buildings of every class, seeds 2001 and
// up, by four scanners, and in pairs of different buildings. No real log has part in them.

/// Weights of probability_features in that order, and the constant.
constexpr ProbabilityFeatures kWeights{0.24534,
                                       -0.819274,
                                       -0.288746,
                                       -0.362711,
                                       0.0143252,
                                       12.3446,
                                       -6.32875,
                                       4.00125,
                                       0.865898,
                                       0.48783,
                                       -1.95087,
                                       -2.34941,
                                       -26.0672,
                                       13.1724};
constexpr double kConstant = -13.8106;
/// The monotone map of the log odds: a line that is steeper from kKnee on.
constexpr double kSlope = 0.937943;
constexpr double kSlopeAboveKnee = 0.429406;  ///< In addition.
constexpr double kKnee = 2.0;
constexpr double kOffset = -0.0789919;

}  // namespace

ProbabilityFeatures probability_features(const ProbabilityEvidence& evidence) {
  const WallKinds& kinds = evidence.kinds;
  const double agreeing_m = kinds.loose_m;
  const double judged_m = agreeing_m + kinds.contradicted_m + kinds.unexplained_m + kLittle_m;
  return {pieces(agreeing_m, 1.0),
          pieces(kinds.contradicted_m, kPiece_m),
          pieces(kinds.unexplained_m, kPiece_m),
          pieces(kinds.outside_m, 1.0),
          pieces(kinds.hidden_m, 1.0),
          evidence.margin,
          evidence.score,
          pieces(evidence.distinct_wall_m, 0.5),
          pieces(evidence.constraint.open_direction_m, 0.1),
          pieces(evidence.constraint.turning_m3, 1.0),
          evidence.one_way_share,
          agreeing_m / judged_m,
          kinds.contradicted_m / judged_m,
          kinds.tight_m / (agreeing_m + kLittle_m)};
}

double log_odds_of(const ProbabilityFeatures& features) {
  return std::inner_product(features.begin(), features.end(), kWeights.begin(), kConstant);
}

double calibrated_log_odds(double log_odds) {
  return kOffset + kSlope * log_odds + kSlopeAboveKnee * std::max(0.0, log_odds - kKnee);
}

double match_probability(const ProbabilityEvidence& evidence, std::size_t num_aliases) {
  const double log_odds = calibrated_log_odds(log_odds_of(probability_features(evidence)));
  const double alone = 1.0 / (1.0 + std::exp(-log_odds));
  return alone / static_cast<double>(1 + num_aliases);
}

}  // namespace setsquare
