// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/locate_scan.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include "setsquare/core/sort_by.hpp"
#include "setsquare/localisation/known_map.hpp"
#include "setsquare/localisation/place_covariance.hpp"
#include "setsquare/localisation/place_probability.hpp"
#include "setsquare/localisation/place_search.hpp"
#include "setsquare/localisation/view_probability.hpp"

namespace setsquare {

LocalisationStatus status_of(double best,
                             double min_probability,
                             double in_map,
                             const LocalisationParams& params) {
  if (best >= min_probability) return LocalisationStatus::kLocalised;
  return in_map >= params.min_in_map ? LocalisationStatus::kAmbiguous : LocalisationStatus::kLost;
}

namespace {

/// Log odds of each place, by the grid.
std::vector<double> log_odds_by_grid(std::span<const VerifiedPlace> found) {
  const PlaceScale scale = place_scale(found, true);
  std::vector<double> log_odds;
  for (const VerifiedPlace& place : found) log_odds.push_back(place_log_odds(place, scale));
  return log_odds;
}

LocatedScan located_by(const KnownMap& map,
                       std::span<const VerifiedPlace> found,
                       std::span<const double> log_odds,
                       double min_probability,
                       const LocalisationParams& params) {
  const std::vector<double> probabilities = place_probabilities(log_odds);
  constexpr double kLeast = 0.001;
  LocatedScan located;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (probabilities[i] < kLeast) continue;
    located.places.push_back(
        {map.T_map_grid() * found[i].T_grid_sensor,
         probabilities[i],
         turned_covariance(covariance_of(found[i]), map.T_map_grid().theta_rad)});
  }
  sort_by_greatest(located.places, &PossiblePlace::probability);
  const double in_map = std::accumulate(probabilities.begin(), probabilities.end(), 0.0);
  const double best = located.places.empty() ? 0.0 : located.places.front().probability;
  located.status = status_of(best, min_probability, in_map, params);
  return located;
}

}  // namespace

LocatedScan locate_scan(const KnownMap& map, const Scan& scan, const LocalisationParams& params) {
  const SoughtScan sought = sought_scan(scan);
  PlaceSearchParams widest = params.search;
  widest.num_proposals = std::max(widest.num_proposals, params.search_again.num_proposals);
  PlaceSearch search(map, sought, widest);
  const std::vector<VerifiedPlace> found = search.best(params.search);
  const double at_once = params.min_probability_at_once;
  const LocatedScan located = located_by(map, found, log_odds_by_grid(found), at_once, params);
  if (located.status == LocalisationStatus::kLocalised) return located;
  const std::vector<VerifiedPlace> wider = search.best(params.search_again);
  if (map.views().empty()) {
    return located_by(map, wider, log_odds_by_grid(wider), at_once, params);
  }
  const std::vector<double> log_odds =
      log_odds_by_views(wider, seen_by_views(map.views(), sought.prepared, wider));
  return located_by(map, wider, log_odds, params.min_probability_by_views, params);
}

}  // namespace setsquare
