// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/pieces/steps_across_break.hpp"

#include <algorithm>

#include "setsquare/tracking/agreed_place.hpp"
#include "setsquare/tracking/long_steps.hpp"

namespace setsquare {

StepReach reach_about_break(const KeyframeTrack& track,
                            std::size_t begin,
                            const LongStepParams& params) {
  LongSteps steps(params);
  const std::size_t half = params.num_steps / 2;
  const std::size_t first = begin - std::min(begin - 1, half);
  for (std::size_t k = first; k < std::min(begin + half + 1, track.size()); ++k) {
    if (track.pieces[k] != track.pieces[k - 1]) continue;
    steps.add(track.keyframes[k - 1]->T_odom_sensor.inverse() * track.keyframes[k]->T_odom_sensor);
  }
  return steps.reach();
}

double log_odds_across_steps(const MatchResult& match,
                             std::size_t num_steps,
                             StepReach step_reach,
                             const StepOddsParams& params) {
  step_reach.distance_m *= static_cast<double>(num_steps);
  step_reach.turn_rad *= static_cast<double>(num_steps);
  const double against =
      odds_against({.T_odom_sensor = {}, .reach = step_reach}, *match.T_reference_current, params);
  return log_odds_of_place(match.probability, against, params);
}

}  // namespace setsquare
