// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from place_probability, which knows the grid alone.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/localisation/map_views.hpp"
#include "setsquare/localisation/place_search.hpp"

namespace setsquare {

/// As seen_by_views(), at each place.
[[nodiscard]] std::vector<SeenByViews> seen_by_views(const MapViews& views,
                                                     const PreparedScan& scan,
                                                     std::span<const VerifiedPlace> places);

inline constexpr std::size_t kNumViewFeatures = 12;
using ViewFeatures = std::array<double, kNumViewFeatures>;

/// How sharply the scan falls on what the views saw at its best place, 0 to 1: it says how much
/// small distances tell.
struct ViewSharpness {
  double distance_m = 0.0;  ///< Of the sharpest place on which the scan lies as well as on any.
  double weight = 0.0;      ///< Near 1 where that is far below 2 cm.
};
[[nodiscard]] ViewSharpness view_sharpness(std::span<const SeenByViews> seen);

/// What the views tell of a place, as the numbers that its rank is a weighted sum of, together with
/// place_features.
[[nodiscard]] ViewFeatures view_features(const SeenByViews& seen, const ViewSharpness& sharpness);

/// How the places of one scan compare, one rank each. A place of which the views tell nothing is
/// compared by the grid alone (place_rank) with the best of those of which they do.
[[nodiscard]] std::vector<double> ranks_by_views(std::span<const VerifiedPlace> places,
                                                 std::span<const SeenByViews> seen);

/// Log odds of each place of a whole map against "somewhere else, or not in the map". One is never
/// sure where neither the grid (kMaxUnjudged) nor the views can judge the scan. `seen`: one per
/// place.
[[nodiscard]] std::vector<double> log_odds_by_views(std::span<const VerifiedPlace> places,
                                                    std::span<const SeenByViews> seen);

}  // namespace setsquare
