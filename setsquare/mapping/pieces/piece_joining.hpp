// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/mapping/loops/loop_closer.hpp"
#include "setsquare/mapping/mapper_params.hpp"

namespace setsquare {

/// How pieces of track are joined.
struct JoinedPieces {
  /// To add to the tracked headings of each piece. Walls fix it only modulo a quarter turn and per
  /// building frame; matches fix the rest.
  std::vector<double> turn_rad;
  std::vector<bool> is_joined;         ///< With the largest piece; that one is.
  std::vector<ComparedPlaces> joints;  ///< Accepted.
};

/// Finds where pieces of track belong that tracking could not tie to each other.
///
/// 1. Across each break the keyframes just before and just after are matched without a guess, pair
///    by pair; where they agree, the pieces hang together.
/// 2. Places of what hangs together are compared by their signatures with those of all that has
///    been joined so far.
/// 3. The most similar are matched by the guess-free matcher; its answer is verified submap against
///    submap.
/// 4. Where enough places agree upon where the piece lies, and more than upon any other place, it
///    is joined.
/// `T_map_sensor`: one per keyframe, right within each piece. Throws ParameterError.
[[nodiscard]] JoinedPieces join_pieces(const KeyframeTrack& track,
                                       std::span<const Pose2> T_map_sensor,
                                       const LoopCloserParams& closing,
                                       const PieceJoiningParams& params,
                                       std::size_t num_threads);

}  // namespace setsquare
