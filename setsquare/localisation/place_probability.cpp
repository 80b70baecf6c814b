// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/place_probability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace setsquare {
namespace {

/// Metres beyond which a metre more tells less and less.
double in_pieces(double length, double unit) { return std::log1p(std::max(0.0, length) / unit); }

// Conditional logistic regression (benchmarks/localisation/fit) over 3533 scans of simulated
// buildings, seeds from 1 and from 13 on, mapped whole or in part, by five scanners; furniture had
// moved meanwhile. No real log has part in them.
constexpr PlaceFeatures kRankWeights{12.3675,
                                     7.00961,
                                     1.32019,
                                     0.950865,
                                     1.24918,
                                     0.0,
                                     -1.30413,
                                     -0.0935423,
                                     0.989172,
                                     0.0585264,
                                     -0.450002,
                                     -1.14027};
constexpr PlaceFeatures kPresenceWeights{0.737366,
                                         3.46331,
                                         1.83233,
                                         2.08584,
                                         1.06318,
                                         -5.30756,
                                         -3.28041,
                                         -0.425687,
                                         0.636825,
                                         0.530168,
                                         -1.15237,
                                         -0.283633};
constexpr double kPresenceConstant = -4.74598;

double weighted(const PlaceFeatures& features, const PlaceFeatures& weights) {
  return std::inner_product(features.begin(), features.end(), weights.begin(), 0.0);
}

}  // namespace

PlaceFeatures place_features(const VerifiedPlace& place) {
  constexpr double kPiece_m = 0.25;
  const WallKinds& seen = place.kinds.forward;
  const WallKinds& expected = place.kinds.backward;
  return {place.fit,
          place.score,
          in_pieces(place.distinct_wall_m, 0.5),
          in_pieces(place.constraint.open_direction_m, 0.1),
          in_pieces(place.constraint.turning_m3, 1.0),
          place.unlined_share,
          in_pieces(seen.loose_m, 1.0),
          in_pieces(seen.unexplained_m, kPiece_m),
          in_pieces(seen.outside_m, 1.0),
          in_pieces(expected.contradicted_m, kPiece_m),
          in_pieces(expected.unexplained_m, kPiece_m),
          in_pieces(expected.outside_m, 1.0)};
}

double place_rank(const PlaceFeatures& features) { return weighted(features, kRankWeights); }

double presence_log_odds(const PlaceFeatures& features) {
  return weighted(features, kPresenceWeights) + kPresenceConstant;
}

PlaceScale place_scale(std::span<const VerifiedPlace> places) {
  PlaceScale scale{.best_rank = -std::numeric_limits<double>::infinity()};
  for (const VerifiedPlace& place : places) {
    const PlaceFeatures features = place_features(place);
    const double rank = place_rank(features);
    if (rank > scale.best_rank) scale = {rank, presence_log_odds(features)};
  }
  return scale;
}

double place_log_odds(const VerifiedPlace& place, const PlaceScale& scale) {
  constexpr double kMinKnown = 0.75;  // Of the returns; with less ...
  constexpr double kUnsure = 2.0;     // ... no place is surer than this.
  const double log_odds = scale.presence + place_rank(place_features(place)) - scale.best_rank;
  return place.known_share < kMinKnown ? std::min(log_odds, kUnsure) : log_odds;
}

std::vector<double> place_probabilities(std::span<const double> log_odds) {
  double most = 0.0;  // Of "elsewhere".
  for (const double value : log_odds) most = std::max(most, value);
  double sum = std::exp(-most);
  for (const double value : log_odds) sum += std::exp(value - most);
  std::vector<double> probabilities;
  for (const double value : log_odds) probabilities.push_back(std::exp(value - most) / sum);
  return probabilities;
}

}  // namespace setsquare
