// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from the search: tests and the fit (benchmarks/localisation) look at it alone.
#pragma once

#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "setsquare/localisation/place_search.hpp"

namespace setsquare {

inline constexpr std::size_t kNumPlaceFeatures = 12;
using PlaceFeatures = std::array<double, kNumPlaceFeatures>;

/// A weight for each feature.
template <std::size_t kSize>
[[nodiscard]] double weighted_sum(const std::array<double, kSize>& features,
                                  const std::array<double, kSize>& weights) {
  return std::inner_product(features.begin(), features.end(), weights.begin(), 0.0);
}

/// A length in units beyond which a metre more tells less and less.
[[nodiscard]] double in_pieces(double length, double unit);

/// What was measured at a place, as the numbers that its rank and its odds are weighted sums of.
[[nodiscard]] PlaceFeatures place_features(const VerifiedPlace& place);

/// How places of one scan compare: a difference of 1 is a factor of e in probability.
[[nodiscard]] double place_rank(const PlaceFeatures& features);

/// Log odds that a scan was taken in the map at all, by one of its places alone: where nothing else
/// was looked at.
[[nodiscard]] double presence_log_odds(const PlaceFeatures& features);

/// How far the best place of a whole map stands out of the others, in rank: chance finds many
/// places that are about as good, a place that is right is alone.
struct PlaceStanding {
  static constexpr double kMost = 15.0;  ///< Farther is not told apart; nor is a single place.
  double above_second = kMost;           ///< Of all different places.
  double above_others = kMost;           ///< Of the five that follow it, on average.
};

/// Of at least one place, in any order; places that are one (is_one_place) count once.
[[nodiscard]] PlaceStanding place_standing(std::span<const VerifiedPlace> places);
/// The same by other ranks than place_rank, one per place.
[[nodiscard]] PlaceStanding place_standing(std::span<const VerifiedPlace> places,
                                           std::span<const double> ranks);

/// Log odds that a scan was taken in the map at all, by the best of all places and its standing.
[[nodiscard]] double presence_log_odds(const VerifiedPlace& best, const PlaceStanding& standing);

/// By what places of one scan are judged: the best of them.
struct PlaceScale {
  double best_rank = 0.0;
  double presence = 0.0;  ///< Log odds that the scan was taken in the map.
};

/// Of at least one place. `is_whole_map`: they are the best of the whole map, not some of them.
[[nodiscard]] PlaceScale place_scale(std::span<const VerifiedPlace> places, bool is_whole_map);

/// A place is never sure where the map cannot judge half of the scan: a corridor whose end is not
/// mapped looks the same from its other end.
inline constexpr double kMaxUnjudged = 0.5;  ///< Of the beams; with more ...
inline constexpr double kUnsure = 2.0;       ///< ... its log odds are no more than this.

/// Log odds of a place of the scan against "somewhere else, or not in the map".
[[nodiscard]] double place_log_odds(const VerifiedPlace& place, const PlaceScale& scale);

/// Probabilities of places, of which at most one is right, from their log odds: they sum to less
/// than 1, the rest is "somewhere else".
[[nodiscard]] std::vector<double> place_probabilities(std::span<const double> log_odds);

}  // namespace setsquare
