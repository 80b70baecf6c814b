// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "setsquare/core/angle.hpp"

namespace setsquare {

/// How the places of a map are searched.
struct PlaceSearchParams {
  std::size_t num_rotations = 120;  ///< Of the circle.
  std::size_t num_proposals = 400;  ///< Best of the correlation.
  std::size_t num_compared = 120;   ///< Best of those, all different, compared range by range.
  std::size_t num_verified = 30;    ///< Best of those, verified.

  /// The same for a map with so much free space: fewer in one that is smaller than half a floor.
  /// As many there stand near each other, and the true one among the very first.
  [[nodiscard]] PlaceSearchParams in_area(double free_m2) const;

  /// Throws ParameterError that names the field as one of `owner`.
  void validate(const std::string& owner) const;
};

/// How scan after scan is followed in a map. Every default works.
struct LocalisationParams {
  PlaceSearchParams search;  ///< How places are found.
  /// How they are where one scan is all there is and the first search finds no certain place, at
  /// the rotations of the first: views into parts that are not mapped agree with the map less than
  /// many a wrong place does.
  PlaceSearchParams search_again{.num_proposals = 2000, .num_compared = 600, .num_verified = 60};
  double min_probability = 0.97;           ///< Of one place: localised.
  double min_probability_at_once = 0.985;  ///< The same where one scan is all there is.
  /// The same where the map's own scans tell it (KnownMap::views).
  double min_probability_by_views = 0.97;
  double min_in_map = 0.5;  ///< Of all places together: ambiguous, else lost.
  /// Scans speak for or against places, and are searched for while the place is not known, after
  /// this way or turn: nearer ones tell the same again.
  double evidence_m = 0.4;
  double evidence_rad = rad_from_deg(15.0);  ///< See evidence_m.
  /// Scans are laid onto the map after this way or turn; between, tracking goes on alone.
  double fix_m = 0.1;
  double fix_rad = rad_from_deg(5.0);  ///< See fix_m.
  double evidence_weight = 0.5;        ///< Of each scan's log odds: scans are not independent.
  double settled_m = 2.0;              ///< Driven while one place was certain: no more searching.
  double max_log_odds = 12.0;  ///< Of a place: some contradictions must be able to outweigh it.
  double max_unconfirmed_m =
      8.0;  ///< Driven since a scan confirmed the place: farther, it is lost.

  /// Throws ParameterError that names the field.
  void validate() const;
};

}  // namespace setsquare
