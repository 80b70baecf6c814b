// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/locate_scan.hpp"

#include <algorithm>
#include <numeric>

#include "setsquare/localisation/known_map.hpp"
#include "setsquare/localisation/place_covariance.hpp"
#include "setsquare/localisation/place_probability.hpp"
#include "setsquare/localisation/place_search.hpp"

namespace setsquare {

LocalisationStatus status_of(double best,
                             double min_probability,
                             double in_map,
                             const LocalisationParams& params) {
  if (best >= min_probability) return LocalisationStatus::kLocalised;
  return in_map >= params.min_in_map ? LocalisationStatus::kAmbiguous : LocalisationStatus::kLost;
}

LocatedScan locate_scan(const KnownMap& map, const Scan& scan, const LocalisationParams& params) {
  const std::vector<VerifiedPlace> found = search_places(map, sought_scan(scan), params.search);
  const PlaceScale scale = place_scale(found, true);
  std::vector<double> log_odds;
  for (const VerifiedPlace& place : found) log_odds.push_back(place_log_odds(place, scale));
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
  std::ranges::stable_sort(located.places, std::ranges::greater{}, &PossiblePlace::probability);
  const double in_map = std::accumulate(probabilities.begin(), probabilities.end(), 0.0);
  const double best = located.places.empty() ? 0.0 : located.places.front().probability;
  located.status = status_of(best, params.min_probability_at_once, in_map, params);
  return located;
}

}  // namespace setsquare
