// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from piece_joining, its only user, because that is long enough.
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/mapping/loops/verdict.hpp"

namespace setsquare {

/// Two places that may be the same and, where they are, how.
struct Proposal {
  std::size_t known = 0;   ///< Keyframe.
  std::size_t sought = 0;  ///< Keyframe of a piece that is to be joined to the former's.
  bool is_verified = false;
  /// Of a match across a break: vote_weight(), or among long steps the log odds of its place.
  double weight = 0.0;
  Pose2 T_map_piece;  ///< How all that hangs together with the sought one would move.
  ComparedPlaces places;
};

/// Votes of places: what one place saw is told once, however many others it resembles.
[[nodiscard]] double places_in(const std::vector<Proposal>& proposals);

/// The same, where a place counts the less the more of its walls are contradicted: what looks like
/// it is not yet it.
[[nodiscard]] double places_seen_in(const std::vector<Proposal>& proposals);

/// Votes of matches across a break, where a scan or two is all there may be.
[[nodiscard]] double weight_in(const std::vector<Proposal>& proposals);

/// The surest of matches across a break among long steps: those of one room err alike.
[[nodiscard]] double surest_in(const std::vector<Proposal>& proposals);

}  // namespace setsquare
