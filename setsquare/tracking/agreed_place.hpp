// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/match_result.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"
#include "setsquare/tracking/prepared_keyframes.hpp"
#include "setsquare/tracking/scan_tracker_params.hpp"

namespace setsquare {

/// Where one keyframe, matched with a scan without a guess, has the scan.
struct PlaceVote {
  Pose2 T_odom_sensor;
  MatchStatus status = MatchStatus::kNoOverlap;
};

/// Where keyframes agree that a scan stands.
struct AgreedPlace {
  Pose2 T_odom_sensor;  ///< By the latest keyframe of those that agree.
  double votes = 0.0;   ///< For it: 1 for each match that stands alone, 1/2 for an ambiguous one.
};

/// The votes of the latest keyframes, the latest first.
[[nodiscard]] std::vector<PlaceVote> place_votes(PreparedKeyframes& keyframes,
                                                 const PreparedScan& current,
                                                 const PlaceVoteParams& params);

/// The place with the most votes, which needs one match that stands alone, or two ambiguous ones,
/// and more votes than any other place: one wrong match bends all that follows. Where the scan was
/// tracked to a place that its submap explains, `tracked` speaks for that place as an ambiguous
/// match does.
[[nodiscard]] std::optional<AgreedPlace> agreed_place(std::span<const PlaceVote> votes,
                                                      const std::optional<Pose2>& tracked,
                                                      const PlaceVoteParams& params);

/// Whether two poses are one place.
[[nodiscard]] bool is_same_place(const Pose2& a, const Pose2& b, const PlaceVoteParams& params);

}  // namespace setsquare
