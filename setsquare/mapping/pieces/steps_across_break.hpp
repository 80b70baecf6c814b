// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What a robot's steps say of matches across a break of a log of key frames.
#pragma once

#include <cstddef>

#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/scan/match_result.hpp"
#include "setsquare/tracking/scan_tracker_params.hpp"
#include "setsquare/tracking/step_reach.hpp"

namespace setsquare {

/// How far the robot may go from keyframe to keyframe, by the steps before a break and behind it.
/// `begin`: the keyframe behind it, not the first of all.
[[nodiscard]] StepReach reach_about_break(const KeyframeTrack& track,
                                          std::size_t begin,
                                          const LongStepParams& params);

/// The log odds that a match with a pose is right, of two keyframes so many steps apart.
/// `step_reach`: of one step.
[[nodiscard]] double log_odds_across_steps(const MatchResult& match,
                                           std::size_t num_steps,
                                           StepReach step_reach,
                                           const StepOddsParams& params);

}  // namespace setsquare
