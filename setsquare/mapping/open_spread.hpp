// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from keyframe_track, which lays the track out: how far it may be off along corridors.
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <span>
#include <vector>

#include "setsquare/graph/pose_graph.hpp"
#include "setsquare/mapping/keyframe_track.hpp"

namespace setsquare {

/// Covariance of the translation of each motion (that to keyframe k; the first's is unused), in the
/// map frame, in m^2. `turn_rad`: from the odom frame to the map frame, one per motion.
///
/// In a corridor without odometry the robot's speed is not seen, and over one open stretch that is
/// one error: the sigmas s_k of its motions add up to S. Each has the variance s_k S: together they
/// have S^2, and what pulls the stretch to another length pulls each of its motions by its share.
/// Where the corridor is straight its motions are open along one direction exactly: with a sigma of
/// metres, directions that differ by the noise of the walls' normals would let it zigzag.
[[nodiscard]] std::vector<Eigen::Matrix2d> motion_covariances_m2(const KeyframeTrack& track,
                                                                 std::span<const double> turn_rad);

/// What makes closures that bind across a corridor only fit for a graph with long open stretches.
/// The direction that such a closure leaves open is known to a degree or so. Where the way between
/// its places may be off by metres along it, the closure may be off across by its share of that,
/// and its information shrinks. Else a few millimetres across decide upon metres along, and the
/// corridor collapses.
///
/// `graph`: the motions of the track in their order first (pose_graph_of), then closures; with
/// heading measurements where ways are to be known by the closures of both axes, too; else by the
/// motions alone, which takes less time.
void loosen_across(std::size_t num_motions, bool is_by_closures, PoseGraph& graph);

}  // namespace setsquare
