// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Pieces that a map has joined before.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/mapping/anchored_keyframes.hpp"
#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/mapping/loops/verdict.hpp"
#include "setsquare/mapping/mapper_params.hpp"

namespace setsquare {

/// Of a joint by the match of two scans. `open_direction_rad`: what the match leaves open, in the
/// first one's frame.
[[nodiscard]] Eigen::Matrix3d information_of_joint(
    const PieceJoiningParams& params, std::optional<double> open_direction_rad = std::nullopt);

/// Lays what a map knows as it lies there. `T_here_sensor`: one per keyframe; the first one that is
/// known stays.
void lay_known(std::span<const AnchoredKeyframe> known, std::span<Pose2> T_here_sensor);

/// Of each piece that is known, but the first, some of its keyframes, each seen from the one of the
/// pieces before it that is nearest to it: from those, to the piece's.
[[nodiscard]] std::vector<std::vector<ComparedPlaces>> known_joints(
    const KeyframeTrack& track,
    std::span<const AnchoredKeyframe> known,
    const PieceJoiningParams& params);

}  // namespace setsquare
