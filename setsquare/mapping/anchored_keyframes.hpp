// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The frame of a map that is gone on with stays where it was.
#pragma once

#include <cstddef>
#include <span>

#include "setsquare/core/pose2.hpp"
#include "setsquare/graph/pose_graph.hpp"
#include "setsquare/headings/fusion.hpp"

namespace setsquare {

/// A keyframe of the map that is gone on with, where that map has it: users know places by it.
struct AnchoredKeyframe {
  std::size_t keyframe = 0;
  Pose2 T_map_sensor;
};

/// The motion that brings the graph's poses, all in all, nearest to where the anchors have them.
[[nodiscard]] Pose2 motion_to_anchors(const PoseGraph& graph,
                                      std::span<const AnchoredKeyframe> anchors);

/// Moves the poses, and turns the headings with them.
void move_by(const Pose2& T, PoseGraph& graph, FusedHeadings& headings);

}  // namespace setsquare
