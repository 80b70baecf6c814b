// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "setsquare/headings/fusion.hpp"
#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/mapping/mapper_params.hpp"

namespace setsquare {

/// Tells slips of tracking from walls that are not square to the others: where the walls turned
/// against the tracked rotation (DoubtedTurn), scans before and behind are matched without a guess.
/// What the matches say of a step is kept.
class TurnChecks {
 public:
  explicit TurnChecks(const TurnCheckParams& params = {}) : params_(params) {}

  /// The headings by the walls and the tracked rotations, checked where they contradict each other.
  [[nodiscard]] FusedHeadings fuse(const KeyframeTrack& track,
                                   const std::vector<HeadingEvidence>& evidence,
                                   const HeadingFusionParams& params);

  /// What is known of a turn from elsewhere: from keyframe turn.from to turn.to the robot turned by
  /// `beyond_rad` more than was tracked. Nobody asks again.
  void decide(const DoubtedTurn& turn, double beyond_rad);

  /// Walls that are turned, by what places show that were seen twice: as fuse_headings() takes
  /// them, behind those that are known already.
  void turn_walls(std::span<const TurnedWalls> turned);

  /// Of the keyframes only those of these indices, which ascend, are left. A step over some that
  /// are forgotten is confirmed: how far it turned was taken from headings that were fused.
  void keep_only(std::span<const std::size_t> kept);

 private:
  struct Step {
    bool is_checked = false;
    bool is_confirmed = false;
    double slip_rad = 0.0;  ///< How far it turned beyond what was tracked.
  };
  struct SeenTurn;
  class Matches;

  /// What is known of the steps put into the evidence.
  [[nodiscard]] std::vector<HeadingEvidence> checked(std::vector<HeadingEvidence> evidence) const;
  /// Whether anything new is known of the steps of a turn.
  bool check(const DoubtedTurn& turn, Matches& matches);
  /// The same headings with the turns that nobody decided held for other walls, where tracking
  /// would have slipped by far more than it errs: not of scans of few beams. They stay in doubt.
  /// And with the walls turned that are known to be.
  [[nodiscard]] FusedHeadings with_turns_held(FusedHeadings fused,
                                              const KeyframeTrack& track,
                                              const std::vector<HeadingEvidence>& evidence,
                                              const HeadingFusionParams& params) const;
  /// How far keyframe b is turned against a beyond what was tracked and the slips known so far.
  [[nodiscard]] std::optional<SeenTurn> beyond_known(std::size_t a,
                                                     std::size_t b,
                                                     Matches& matches) const;
  /// Whether the robot turned as far as is known.
  [[nodiscard]] bool agrees(const SeenTurn& seen) const;
  /// Confirms the steps of a turn from match to match.
  void hop_along(const DoubtedTurn& turn, Matches& matches);
  /// Steps that this left open: confirmed by a match across all of them, or slipped, where several
  /// tell the same slip.
  void bridge(const DoubtedTurn& gap, Matches& matches);

  TurnCheckParams params_;
  std::vector<Step> steps_;          ///< To each keyframe; the first is unused.
  std::vector<TurnedWalls> turned_;  ///< Of the keyframes as they are now.
};

}  // namespace setsquare
