// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from map_maker, its only caller, because tests compare it with plain twins.
#pragma once

#include <span>
#include <vector>

#include "setsquare/graph/pose_graph.hpp"
#include "setsquare/headings/fusion.hpp"
#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/mapping/mapper_params.hpp"

namespace setsquare {

/// How many keyframes share the error of each heading measurement, itself among them: one value, at
/// least its own share of a place, per entry of `graph.headings`. A wall that is off square, or the
/// cupboard before it, is so for all keyframes that see it, on every pass. Keyframes see the same
/// walls by exp(-d^2 / 2 r^2), d apart in the map and r = `same_walls_m`; one of less information
/// counts as so much less. `shares_of_place`: of each node (HeadingEvidence).
[[nodiscard]] std::vector<double> keyframes_of_same_walls(const PoseGraph& graph,
                                                          std::span<const double> shares_of_place,
                                                          double same_walls_m);

/// Variance of the tracked rotations over the one that is stated for them, by what registration
/// changed about them; see HeadingSpreadParams. Of the motions of the track, which come first in
/// `graph`, those count that nothing disturbed.
[[nodiscard]] double rotation_variance_scale(const KeyframeTrack& track,
                                             const PoseGraph& graph,
                                             const HeadingSpreadParams& params);

/// Divides the informations of the headings that walls of other frames than the main one measured,
/// so that together they know a frame no better than its offset is known: it is an error that all
/// of them share. `variance_scale`: of the offsets' variances, which rest on tracked rotations.
void share_frame_offsets(const FusedHeadings& headings, double variance_scale, PoseGraph& graph);

/// Makes the graph of a finished map tell how certain its headings are. What served the poses took
/// each measurement of a heading for independent and each scanner for equally good:
///
/// 1. The keyframes of one place have the information of one (keyframes_of_same_walls).
/// 2. Tracked rotations are as uncertain as this log shows (rotation_variance_scale); where
///    something disturbed them, never more certain than stated.
/// 3. A wing is turned as a whole by what its offset is off (share_frame_offsets).
void spread_headings(const KeyframeTrack& track,
                     const FusedHeadings& headings,
                     std::span<const double> shares_of_place,
                     const HeadingSpreadParams& params,
                     PoseGraph& graph);

}  // namespace setsquare
