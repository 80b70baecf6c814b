// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from piece_joining, its only caller: one question, tested alone.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/mapping/mapper_params.hpp"

namespace setsquare {

/// Where a piece of track is said to lie.
struct JoiningClaim {
  Pose2 T_map_piece;                ///< How it would move.
  std::vector<std::size_t> places;  ///< Its keyframes that say so.
  std::vector<bool> known;          ///< The keyframes that are known, of the track's ...
  std::vector<bool> piece;          ///< ... and those of the piece.
};

/// Whether the places that say where a piece of another session lies may be those of a room that is
/// alike: they lie no farther apart than those of one room do, or of the keyframes about them too
/// many see through what is known there, or of those beside them, a little farther along the track.
/// Two rooms that are alike lie at different places of different corridors.
[[nodiscard]] bool may_be_twin(const JoiningClaim& claim,
                               const KeyframeTrack& track,
                               std::span<const Pose2> T_map_sensor,
                               const PieceJoiningParams& params);

/// The second of these alone: a piece that is joined so lies in the walls of the map.
[[nodiscard]] bool sees_through_map(const JoiningClaim& claim,
                                    const KeyframeTrack& track,
                                    std::span<const Pose2> T_map_sensor,
                                    const PieceJoiningParams& params);

}  // namespace setsquare
