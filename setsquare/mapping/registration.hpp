// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/graph/pose_graph.hpp"
#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/tracking/submap_alignment.hpp"

namespace setsquare {

/// Moves all keyframes at once until the scans agree: every keyframe is compared, point to line,
/// with those just before it and with those of earlier visits, each comparison's normal equations
/// become a constraint, and the graph of all of them is polished together with the headings
/// measured against the building. The surfaces themselves decide, not the poses found earlier.
///
/// `closures` name the keyframes that see a place again, `from` before `to`: the keyframes around
/// them are compared instead; a closure without a usable comparison stays as it is.
/// `graph`: poses of the sensors near their places, which are moved; heading measurements; and the
/// constraints that hold in addition to the comparisons, by their weights. Any number of threads
/// gives the same poses.
void register_keyframes(const KeyframeTrack& track,
                        std::span<const Constraint> closures,
                        PoseGraph& graph,
                        const RegistrationParams& params,
                        std::size_t num_threads);

}  // namespace setsquare
