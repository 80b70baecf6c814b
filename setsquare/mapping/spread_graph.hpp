// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// How certain the poses of a map's graph are.
#pragma once

#include <cstddef>
#include <span>

#include "setsquare/graph/pose_graph.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/tracking/step_reach.hpp"

namespace setsquare {

/// The map's graph as far as it tells how certain poses are. For round halls, and for headings that
/// were lost. What serves the poses is too sure of itself there:
///
/// 1. Walls that leave a turn open (MappedScan::is_turn_open) tell no heading: there the motion is
///    as uncertain as a turn about the middle, and such a keyframe's heading measurement and its
///    closures are left out. Taking the turn about the middle out of the closures is not enough:
///    they do not agree upon the middle, and many of them bind the turn by what they differ.
/// 2. The building's walls tell a heading modulo a quarter turn, and where it has wings modulo the
///    angle between them. Behind a turn that is known to no better than a sixth of that (15
///    degrees, or less) which of them it is is a guess: heading measurements count on one side of
///    it only, where they have the most information. A closure over it brings them together again.
/// 3. A long step that no independent match seconds may be a wrong one: it is as uncertain as such
///    steps are, or as the odometry where that tells it, too. Closures across it of keyframes that
///    no more than kMaxSecondingSteps lie between were found where it led, and are left out.
/// 4. A step that departs from odometry that has proved true, or from what the last scan says of a
///    jolt, is as uncertain as the two differ: where there are people or clutter about the robot a
///    scan is pulled aside. It is so here only: mostly the
///    scans are right, and headings told by walls hang on the tracked rotation.
/// `unseconded`: the keyframes to which they lead (AuditFindings::unseconded).
[[nodiscard]] PoseGraph spread_graph(const Map& map, std::span<const std::size_t> unseconded = {});

/// How far a wrong step to a keyframe leads, among key frames (standard deviations).
[[nodiscard]] StepReach wrong_step_sigma(const Map& map, std::size_t keyframe);

/// Whether a constraint is a tracked motion, from one keyframe to the next.
[[nodiscard]] bool is_tracked_step(const Constraint& constraint);

}  // namespace setsquare
