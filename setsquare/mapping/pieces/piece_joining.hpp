// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/map/map_track.hpp"
#include "setsquare/mapping/anchored_keyframes.hpp"
#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/mapping/loops/loop_closer.hpp"
#include "setsquare/mapping/mapper_params.hpp"

namespace setsquare {

/// How pieces of track are joined.
struct JoinedPieces {
  /// To add to the tracked headings of each piece. Walls fix it only modulo a quarter turn and per
  /// building frame; matches fix the rest.
  std::vector<double> turn_rad;
  std::vector<bool> is_joined;         ///< With the largest piece (of KeyframeTrack::num_known).
  std::vector<ComparedPlaces> joints;  ///< Accepted.
  /// How it went when each piece was looked for, with what hangs together with it; the last time.
  std::vector<SessionSearch> searches;
};

/// Finds where pieces of track belong that tracking could not tie to each other.
///
/// 0. Pieces that a map has joined lie as they lay there.
/// 1. Across each break of a session the keyframes just before and just after are matched without a
/// guess, pair
///    by pair; where they agree, the pieces hang together.
/// 2. Places of what hangs together are compared by their signatures with those of all that has
///    been joined so far.
/// 3. The most similar are matched by the guess-free matcher; its answer is verified submap against
///    submap.
/// 4. Where enough places agree upon where the piece lies, and more than upon any other place, it
///    is joined.
/// 5. A piece of another session only if they are not all of one room, and what both saw beside
/// them
///    is the same, too: nothing else tells apart two rooms that are alike.
/// `T_map_sensor`: one per keyframe, right within each piece. `known`: keyframes that lie in a map,
/// in their order, whose pieces are not looked for again. Throws ParameterError.
[[nodiscard]] JoinedPieces join_pieces(const KeyframeTrack& track,
                                       std::span<const Pose2> T_map_sensor,
                                       std::span<const AnchoredKeyframe> known,
                                       const LoopCloserParams& closing,
                                       const PieceJoiningParams& params,
                                       std::size_t num_threads);

}  // namespace setsquare
