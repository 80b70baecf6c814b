// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/view_probability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "setsquare/localisation/place_probability.hpp"

namespace setsquare {
namespace {

constexpr double kPiece_m = 0.25;
/// With less wall on walls their distance tells nothing: they count as far off.
constexpr double kLeastLoose_m = 0.5;
constexpr double kFar_m = 0.1;

// benchmarks/localisation/fit, over the scans of place_probability's figures: the weights of
// place_features and of view_features in the rank, over places of which views tell ...
constexpr PlaceFeatures kPlaceWeights{9.8803,
                                      3.15766,
                                      1.09855,
                                      1.57127,
                                      1.53044,
                                      0.0,
                                      -3.66627,
                                      -1.02726,
                                      1.06092,
                                      0.293874,
                                      -0.484165,
                                      -2.17539};
constexpr ViewFeatures kViewWeights{3.76314,
                                    -0.443099,
                                    -0.962198,
                                    0.312424,
                                    0.316544,
                                    0.25639,
                                    -0.488829,
                                    -0.0581311,
                                    -5.2549,
                                    -0.624388,
                                    -2.13157,
                                    8.98693};
// ... and of the best place's fit and score and of its standing in the odds that the scan was taken
// in the map: over the places of the wider search of 1936 scans, those of the logs and of buildings
// of seeds 1 and 2 (orebro's second half alone).
constexpr std::array<double, 4> kViewStandingWeights{-1.21807, 0.102786, 0.238613, 0.686362};
constexpr double kViewStandingConstant = -2.9437;

/// Of walls that are near; a little is added, for a view's own walls are no better known.
double distance_of(const SeenByViews& seen) {
  constexpr double kOwn_m = 0.002;
  return kOwn_m + (seen.loose_m > kLeastLoose_m ? seen.distance_m : kFar_m);
}

}  // namespace

std::vector<SeenByViews> seen_by_views(const MapViews& views,
                                       const PreparedScan& scan,
                                       std::span<const VerifiedPlace> places) {
  std::vector<SeenByViews> seen;
  for (const VerifiedPlace& place : places) {
    seen.push_back(seen_by_views(views, scan, place.T_grid_sensor));
  }
  return seen;
}

ViewSharpness view_sharpness(std::span<const SeenByViews> seen) {
  constexpr double kSharpest_m = 0.004;
  constexpr double kAsWell = 0.5;
  constexpr double kSharp_m = 0.02;
  double most_m = 0.0;
  for (const SeenByViews& place : seen) most_m = std::max(most_m, place.loose_m);
  double distance_m = kFar_m;
  if (most_m > kLeastLoose_m) {
    distance_m = std::numeric_limits<double>::infinity();
    for (const SeenByViews& place : seen) {
      if (place.num_views == 0 || place.loose_m < kAsWell * most_m) continue;
      distance_m = std::min(distance_m, distance_of(place));
    }
    distance_m = std::max(kSharpest_m, distance_m);
  }
  const double u = distance_m / kSharp_m;
  return {distance_m, 1.0 / (1.0 + u * u)};
}

ViewFeatures view_features(const SeenByViews& seen, const ViewSharpness& sharpness) {
  constexpr double kMostBlurred = 2.5;
  constexpr double kLittle_m = 0.3;
  constexpr double kClutter_m = 0.08;
  constexpr double kPerMetre = 10.0;
  const double weight = sharpness.weight;
  const double through = in_pieces(seen.through_m, kPiece_m);
  const double missed = in_pieces(seen.missed_m, kPiece_m);
  const double blurred =
      std::clamp(std::log(distance_of(seen) / sharpness.distance_m), 0.0, kMostBlurred);
  return {in_pieces(seen.tight_m, 0.5),
          in_pieces(seen.loose_m, 1.0),
          through,
          in_pieces(seen.behind_m, 1.0),
          in_pieces(seen.outside_m, 1.0),
          kPerMetre * (seen.loose_m > kLittle_m ? seen.distance_m : kClutter_m),
          missed,
          in_pieces(seen.unexplained_m, kPiece_m),
          weight * blurred,
          weight * through,
          weight * missed,
          weight * seen.tight_m / std::max(0.1, seen.wall_m)};
}

std::vector<double> ranks_by_views(std::span<const VerifiedPlace> places,
                                   std::span<const SeenByViews> seen) {
  const ViewSharpness sharpness = view_sharpness(seen);
  std::vector<double> ranks;
  std::vector<double> grid_ranks;
  std::optional<std::size_t> best;  // Of those of which the views tell.
  for (std::size_t i = 0; i < places.size(); ++i) {
    const PlaceFeatures features = place_features(places[i]);
    grid_ranks.push_back(place_rank(features));
    ranks.push_back(weighted_sum(features, kPlaceWeights) +
                    weighted_sum(view_features(seen[i], sharpness), kViewWeights));
    if (seen[i].num_views > 0 && (!best || ranks[i] > ranks[*best])) best = i;
  }
  if (!best) return grid_ranks;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (seen[i].num_views == 0) ranks[i] = ranks[*best] + grid_ranks[i] - grid_ranks[*best];
  }
  return ranks;
}

std::vector<double> log_odds_by_views(std::span<const VerifiedPlace> places,
                                      std::span<const SeenByViews> seen) {
  if (places.empty()) return {};
  std::vector<double> log_odds = ranks_by_views(places, seen);
  const PlaceStanding standing = place_standing(places, log_odds);
  const auto highest = std::ranges::max_element(log_odds);
  const double best_rank = *highest;
  const VerifiedPlace& best = places[static_cast<std::size_t>(highest - log_odds.begin())];
  const double presence =
      weighted_sum<4>({best.fit, best.score, standing.above_second, standing.above_others},
                      kViewStandingWeights) +
      kViewStandingConstant;
  for (std::size_t i = 0; i < places.size(); ++i) {
    log_odds[i] += presence - best_rank;
    const bool is_judged = places[i].unjudged_share <= kMaxUnjudged || seen[i].num_views > 0;
    if (!is_judged) log_odds[i] = std::min(log_odds[i], kUnsure);
  }
  return log_odds;
}

}  // namespace setsquare
