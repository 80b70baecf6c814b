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

inline constexpr std::size_t kNumPlaceFeatures = 23;
using PlaceFeatures = std::array<double, kNumPlaceFeatures>;

/// What was measured at a place, as the numbers that its log odds are a weighted sum of.
[[nodiscard]] PlaceFeatures place_features(const VerifiedPlace& place);

/// Log odds of a place against "somewhere else, or not in the map": what one scan says for it.
[[nodiscard]] double place_log_odds(const VerifiedPlace& place);

/// Probabilities of places, of which at most one is right, from their log odds: they sum to less
/// than 1, the rest is "somewhere else".
[[nodiscard]] std::vector<double> place_probabilities(std::span<const double> log_odds);

}  // namespace setsquare
