// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from map_maker, its only caller, because tests drive it without scans.
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/headings/fusion.hpp"
#include "setsquare/mapping/audit/audit.hpp"
#include "setsquare/mapping/loops/loop_closer.hpp"
#include "setsquare/mapping/mapper_params.hpp"

namespace setsquare {

/// How far a keyframe is turned against an earlier one, by what both of them see: a closure, or a
/// match without a guess.
struct SeenTurn {
  std::size_t from = 0;
  std::size_t to = 0;
  double turned_rad = 0.0;
  double sigma_rad = 0.0;
};

/// A turn that was seen, as information of its rotation, given that the translation is as free.
[[nodiscard]] SeenTurn seen_turn(std::size_t from,
                                 std::size_t to,
                                 const Pose2& T_from_to,
                                 const Eigen::Matrix3d& information);

/// Those of the accepted closures, and of the matches of an audit, if there is one.
[[nodiscard]] std::vector<SeenTurn> seen_turns(const LoopCloser& closer,
                                               const AuditFindings* findings);

/// Where turns that were seen outvote the walls: stretches of the track whose headings are to be
/// turned as a whole. One wrong closure turns nothing, however wrong.
///
/// 1. Where no `min_places` places contradict the headings, all is well.
/// 2. Unknown is by how much the heading of each keyframe that a turn names is off, and the offset
///    of each frame. The turns bind two keyframes; neighbours along the track are off alike by the
///    walls, where those of one frame go on, and by the tracked rotations; where a frame's walls
///    begin, the keyframe is off as that frame is. So what breaks easily is a joint of two wings,
///    or a place where walls and tracking do not agree. Geman-McClure, graduated from full weights:
///    each of them is broken at a bounded cost, and turns seen at one place are one.
/// 3. Neighbours that are off alike are a stretch. It counts where enough places ask for it, and a
///    majority over those that it would contradict.
/// `evidence` and `ways_m` (travelled from the first one on): one per keyframe.
[[nodiscard]] std::vector<TurnedWalls> outvoted_walls(const FusedHeadings& headings,
                                                      std::span<const HeadingEvidence> evidence,
                                                      std::span<const double> ways_m,
                                                      std::span<const SeenTurn> seen,
                                                      const OutvotedWallsParams& params);

/// Places at which turns that were seen contradict the headings.
[[nodiscard]] std::size_t num_places_against(const FusedHeadings& headings,
                                             std::span<const double> ways_m,
                                             std::span<const SeenTurn> seen,
                                             const OutvotedWallsParams& params);

}  // namespace setsquare
