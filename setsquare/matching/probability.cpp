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

// The figures below are those that `match_probability fit` prints (benchmarks/match_probability),
// of simulated buildings of every class, seeds 2001 and up. The weights are a logistic regression
// over 54126 best answers by four scanners, in pairs of different buildings, too; the map is one
// over 38162 answers as matches give them, as many buildings of 270, 180 and 360 deg each. No real
// log has part in them.

/// Weights of probability_features in that order, and the constant.
constexpr ProbabilityFeatures kWeights{0.157733,
                                       -0.831864,
                                       -0.578045,
                                       -0.295739,
                                       0.0187764,
                                       13.26,
                                       -6.48689,
                                       3.99877,
                                       0.81407,
                                       0.50467,
                                       -2.3772,
                                       -3.9554,
                                       -25.0651,
                                       12.3796};
constexpr double kConstant = -11.2799;
/// The monotone map of the log odds: a line that is steeper from kKnee on.
constexpr double kSlope = 0.930358;
constexpr double kSlopeAboveKnee = 0.483876;  ///< In addition.
constexpr double kKnee = 2.0;
constexpr double kOffset = 0.21487;

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
