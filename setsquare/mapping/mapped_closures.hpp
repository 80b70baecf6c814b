// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// From the sensor's poses, in which the mapper thinks, to the robot's, which are told.
#pragma once

#include <span>
#include <vector>

#include "setsquare/graph/pose_graph.hpp"
#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/mapping/loops/loop_closer.hpp"
#include "setsquare/mapping/mapped_track.hpp"

namespace setsquare {

/// What was compared, with the final weights of what was accepted. `graph`: of the sensors' poses,
/// the track's motions first, then the accepted closures in the order of `compared`.
[[nodiscard]] std::vector<MappedClosure> mapped_closures(const KeyframeTrack& track,
                                                         std::span<const ComparedPlaces> compared,
                                                         const PoseGraph& graph);

/// The pieces of the track as ranges of scans: each begins with its first keyframe, the first one
/// with the log.
[[nodiscard]] std::vector<TrackPiece> pieces_of(const KeyframeTrack& track,
                                                const std::vector<bool>& is_joined,
                                                std::size_t num_scans);

/// The same graph of the poses of `base`.
[[nodiscard]] PoseGraph graph_of_base(const KeyframeTrack& track, const PoseGraph& graph);

}  // namespace setsquare
