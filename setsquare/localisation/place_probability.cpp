// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/place_probability.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "setsquare/core/sort_by.hpp"

namespace setsquare {
namespace {

// Conditional logistic regression (benchmarks/localisation/fit) over 2369 scans: of simulated
// buildings, seeds 1 to 3, mapped whole or in part, by five scanners, whose furniture had moved
// meanwhile; and of csail, freiburg-101, orebro and seattle, each half in the other's map.
constexpr PlaceFeatures kRankWeights{14.4039,
                                     3.15888,
                                     2.31519,
                                     1.54569,
                                     1.20571,
                                     0.0,
                                     -3.81867,
                                     -0.622507,
                                     0.705026,
                                     0.0420827,
                                     -0.590793,
                                     -1.64388};
// Of simulated buildings alone, seeds from 1 and from 13 on.
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
// By the best of the whole map, over the scans of the rank: its fit and score, and how far it
// stands above the second and above the others.
constexpr std::array<double, 4> kStandingWeights{-0.604915, 1.52757, 0.21977, 0.83691};
constexpr double kStandingConstant = -3.62513;

}  // namespace

double in_pieces(double length, double unit) { return std::log1p(std::max(0.0, length) / unit); }

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

double place_rank(const PlaceFeatures& features) { return weighted_sum(features, kRankWeights); }

double presence_log_odds(const PlaceFeatures& features) {
  return weighted_sum(features, kPresenceWeights) + kPresenceConstant;
}

PlaceStanding place_standing(std::span<const VerifiedPlace> places) {
  std::vector<double> ranks;
  for (const VerifiedPlace& place : places) ranks.push_back(place_rank(place_features(place)));
  return place_standing(places, ranks);
}

PlaceStanding place_standing(std::span<const VerifiedPlace> places, std::span<const double> ranks) {
  std::vector<std::pair<double, const VerifiedPlace*>> ranked;
  for (std::size_t i = 0; i < places.size(); ++i) ranked.emplace_back(ranks[i], &places[i]);
  sort_by_greatest(ranked, &decltype(ranked)::value_type::first);
  constexpr std::size_t kNumOthers = 5;
  std::vector<std::pair<double, const VerifiedPlace*>> different;
  for (const auto& [rank, place] : ranked) {
    const bool is_known = std::ranges::any_of(different, [&](const auto& other) {
      return is_one_place(place->T_grid_sensor, other.second->T_grid_sensor);
    });
    if (!is_known) different.emplace_back(rank, place);
    if (different.size() == 1 + kNumOthers) break;
  }
  PlaceStanding standing;
  if (different.size() < 2) return standing;
  const auto below_best = [&](std::size_t i) {
    return std::min(PlaceStanding::kMost, different[0].first - different[i].first);
  };
  double sum = 0.0;
  for (std::size_t i = 1; i < different.size(); ++i) sum += below_best(i);
  return {below_best(1), sum / static_cast<double>(different.size() - 1)};
}

double presence_log_odds(const VerifiedPlace& best, const PlaceStanding& standing) {
  const std::array measures{best.fit, best.score, standing.above_second, standing.above_others};
  return std::inner_product(
      measures.begin(), measures.end(), kStandingWeights.begin(), kStandingConstant);
}

PlaceScale place_scale(std::span<const VerifiedPlace> places, bool is_whole_map) {
  PlaceScale scale{.best_rank = -std::numeric_limits<double>::infinity()};
  const VerifiedPlace* best = nullptr;
  for (const VerifiedPlace& place : places) {
    const double rank = place_rank(place_features(place));
    if (rank <= scale.best_rank) continue;
    scale.best_rank = rank;
    best = &place;
  }
  if (best == nullptr) return scale;
  scale.presence = is_whole_map ? presence_log_odds(*best, place_standing(places))
                                : presence_log_odds(place_features(*best));
  return scale;
}

double place_log_odds(const VerifiedPlace& place, const PlaceScale& scale) {
  const double log_odds = scale.presence + place_rank(place_features(place)) - scale.best_rank;
  return place.unjudged_share > kMaxUnjudged ? std::min(log_odds, kUnsure) : log_odds;
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
