// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from the search: tests and the fit (benchmarks/localisation) look at it alone.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/localisation/place_search.hpp"

namespace setsquare {

inline constexpr std::size_t kNumPlaceFeatures = 12;
using PlaceFeatures = std::array<double, kNumPlaceFeatures>;

/// What was measured at a place, as the numbers that its rank and its odds are weighted sums of.
[[nodiscard]] PlaceFeatures place_features(const VerifiedPlace& place);

/// How places of one scan compare: a difference of 1 is a factor of e in probability.
[[nodiscard]] double place_rank(const PlaceFeatures& features);

/// Log odds that a scan was taken in the map at all, by the best of its places.
[[nodiscard]] double presence_log_odds(const PlaceFeatures& features);

/// By what places of one scan are judged: the best of them.
struct PlaceScale {
  double best_rank = 0.0;
  double presence = 0.0;  ///< Log odds that the scan was taken in the map.
};

/// Of at least one place.
[[nodiscard]] PlaceScale place_scale(std::span<const VerifiedPlace> places);

/// Log odds of a place of the scan against "somewhere else, or not in the map". A place most of
/// whose scan the map cannot judge is never sure.
[[nodiscard]] double place_log_odds(const VerifiedPlace& place, const PlaceScale& scale);

/// Probabilities of places, of which at most one is right, from their log odds: they sum to less
/// than 1, the rest is "somewhere else".
[[nodiscard]] std::vector<double> place_probabilities(std::span<const double> log_odds);

}  // namespace setsquare
