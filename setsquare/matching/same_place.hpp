// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from answer: tests and the fit (benchmarks/match_probability) look at it alone.
#pragma once

#include <array>
#include <cstddef>

#include "setsquare/matching/probability.hpp"
#include "setsquare/matching/wall_ends.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {

/// What tells whether two scans that agree at a pose show one place at all. A corridor's side and
/// its end are found in every building, and lie on each other to 15 cm; what does not is where the
/// walls end.
struct PlaceEvidence {
  double log_odds = 0.0;  ///< That the pose is right (calibrated_log_odds), of scans of one place.
  WallEndCount ends;
  double close_distinct_m = 0.0;   ///< distinct_wall_m of what agrees to 2 cm.
  double unexplained_share = 0.0;  ///< Of all wall, both scans: hidden by what does not agree.
  double normal_rms_rad = 0.0;     ///< Angle between walls that agree to 15 cm.
  double turning_m3 = 0.0;         ///< Wall that holds the rotation (WallConstraint).
  double narrow_spread_m = 0.0;    ///< Standard deviation of agreeing wall, across its long axis.
};

[[nodiscard]] PlaceEvidence place_evidence(const PreparedScan& reference,
                                           const PreparedScan& current,
                                           const Pose2& T_reference_current,
                                           const ProbabilityEvidence& evidence);

inline constexpr std::size_t kNumPlaceFeatures = 8;
using PlaceFeatures = std::array<double, kNumPlaceFeatures>;

/// The evidence as the numbers that the log odds are a weighted sum of.
[[nodiscard]] PlaceFeatures place_features(const PlaceEvidence& evidence);

/// Log odds that the scans show one place, and not two of different buildings, where as many pairs
/// of answers this probable are of the one kind as of the other.
[[nodiscard]] double place_log_odds(const PlaceEvidence& evidence);

}  // namespace setsquare
