// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/place_probability.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace setsquare {
namespace {

/// Metres beyond which a metre more tells less and less.
double in_pieces(double length, double unit) { return std::log1p(std::max(0.0, length) / unit); }

// The figures that `localisation_study fit` prints (benchmarks/localisation).
constexpr PlaceFeatures kPlaceWeights{};
constexpr double kPlaceConstant = 0.0;

}  // namespace

PlaceFeatures place_features(const VerifiedPlace& place) {
  constexpr double kPiece_m = 0.25;
  constexpr double kLittle_m = 0.5;
  PlaceFeatures features;
  std::size_t next = 0;
  const auto add = [&](double value) { features[next++] = value; };
  add(place.fit);
  add(place.score);
  add(in_pieces(place.distinct_wall_m, 0.5));
  add(in_pieces(place.constraint.open_direction_m, 0.1));
  add(in_pieces(place.constraint.turning_m3, 1.0));
  for (const WallKinds& kinds : {place.kinds.forward, place.kinds.backward}) {
    const double judged_m =
        kinds.loose_m + kinds.contradicted_m + kinds.unexplained_m + kLittle_m;
    add(in_pieces(kinds.loose_m, 1.0));
    add(in_pieces(kinds.contradicted_m, kPiece_m));
    add(in_pieces(kinds.unexplained_m, kPiece_m));
    add(in_pieces(kinds.outside_m, 1.0));
    add(kinds.loose_m / judged_m);
    add(kinds.contradicted_m / judged_m);
    add(kinds.unexplained_m / judged_m);
    add(kinds.tight_m / (kinds.loose_m + kLittle_m));
    add(kinds.outside_m / (kinds.wall_m + kLittle_m));
  }
  return features;
}

double place_log_odds(const VerifiedPlace& place) {
  const PlaceFeatures features = place_features(place);
  return std::inner_product(
      features.begin(), features.end(), kPlaceWeights.begin(), kPlaceConstant);
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
