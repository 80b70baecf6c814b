// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/scan_tracker_params.hpp"

#include <algorithm>

#include "setsquare/core/parameter_checks.hpp"

namespace setsquare {
namespace {

constexpr double kMaxCorridorSteps = 10000.0;

}  // namespace

void PredictionTrust::validate(const std::string& name) const {
  require_not_negative(weight, name + ".weight");
  require_positive(sigma_m, name + ".sigma_m");
  require_not_negative(min_gain, name + ".min_gain");
}

double SubmapRefinementParams::bound_share(double effective_points) const {
  return std::clamp(
      (effective_points - chance_points) / (min_effective_points - chance_points), 0.0, 1.0);
}

void SubmapRefinementParams::validate() const {
  first_step.validate("refinement.first_step");
  later_steps.validate("refinement.later_steps");
  require_at_least_one(max_iterations, "refinement.max_iterations");
  require_positive(converged_m, "refinement.converged_m");
  require_positive(converged_rad, "refinement.converged_rad");
  require_positive(max_step_m, "refinement.max_step_m");
  turn.validate();
  require_not_negative(chance_points, "refinement.chance_points");
  require_finite(min_effective_points, "refinement.min_effective_points");
  if (!(min_effective_points > chance_points)) {
    throw ParameterError("refinement.min_effective_points", "must be above chance_points");
  }
}

void CorridorSearchParams::validate() const {
  require_not_negative(below_effective_points, "corridor.below_effective_points");
  require_positive(step_m, "corridor.step_m");
  require_positive(scale_m, "corridor.scale_m");
  require_positive(half_range_m, "corridor.half_range_m");
  if (!(half_range_m <= kMaxCorridorSteps * step_m)) {
    throw ParameterError("corridor.half_range_m", "must be at most 10000 steps");
  }
  require_not_negative(motion_cost, "corridor.motion_cost");
}

void RecoveryParams::validate() const {
  require_at_least_one(num_keyframes, "recovery.num_keyframes");
  require_finite(below_score, "recovery.below_score");
  require_finite(below_score_if_open, "recovery.below_score_if_open");
  require_finite(enough_score, "recovery.enough_score");
  require_finite(far_min_score, "recovery.far_min_score");
  require_not_negative(min_gain, "recovery.min_gain");
  require_positive(near_m, "recovery.near_m");
  require_positive(near_rad, "recovery.near_rad");
}

void StepOddsParams::validate() const {
  require_not_negative(decades_per_reach, "step_odds.decades_per_reach");
  require_positive(least_wrong, "step_odds.least_wrong");
  if (!(least_wrong < 0.5)) throw ParameterError("step_odds.least_wrong", "must be below 0.5");
}

void PlaceVoteParams::validate() const {
  require_at_least_one(num_keyframes, "votes.num_keyframes");
  require_positive(same_m, "votes.same_m");
  require_positive(same_rad, "votes.same_rad");
  require_not_negative(min_votes_for_jump, "votes.min_votes_for_jump");
  require_not_negative(min_probability, "votes.min_probability");
  require_positive(least_open_sigma_m, "votes.least_open_sigma_m");
  odds.validate();
}

void SuddenTurnParams::validate() const {
  require_finite(below_score, "deskew.sudden_turn.below_score");
  require_not_negative(below_usual, "deskew.sudden_turn.below_usual");
  require_not_negative(near_usual, "deskew.sudden_turn.near_usual");
  require_not_negative(min_turn_rad, "deskew.sudden_turn.min_turn_rad");
  require_finite(min_gain, "deskew.sudden_turn.min_gain");
  require_positive(fastest_rad_per_s, "deskew.sudden_turn.fastest_rad_per_s");
  require_positive(step_rad, "deskew.sudden_turn.step_rad");
  require_positive(scale_m, "deskew.sudden_turn.scale_m");
  require_at_least_one(max_samples, "deskew.sudden_turn.max_samples");
}

void JoltParams::validate() const {
  require_positive(min_m, "jolts.min_m");
  require_positive(min_rad, "jolts.min_rad");
  require_positive(same_m, "jolts.same_m");
  require_positive(same_rad, "jolts.same_rad");
}

void SweepTrialParams::validate() const {
  require_positive(max_period_s, "deskew.trial.max_period_s");
  require_positive(min_turn_rad, "deskew.trial.min_turn_rad");
  require_finite(min_score, "deskew.trial.min_score");
  require_at_least_one(min_turns, "deskew.trial.min_turns");
  require_positive(num_sigmas, "deskew.trial.num_sigmas");
  require_not_negative(max_share_at_once, "deskew.trial.max_share_at_once");
  require_not_negative(max_off_whole, "deskew.trial.max_off_whole");
  if (!(min_share > max_share_at_once)) {
    throw ParameterError("deskew.trial.min_share", "must be above max_share_at_once");
  }
}

void DeskewParams::validate() const {
  require_at_least_one(max_num_turns, "deskew.max_num_turns");
  require_positive(converged_rad, "deskew.converged_rad");
  require_positive(gyro_sigma_rad_per_s, "deskew.gyro_sigma_rad_per_s");
  require_positive(motion_sigma_rad_per_s, "deskew.motion_sigma_rad_per_s");
  sudden_turn.validate();
  trial.validate();
}

void ScanTrackerParams::validate() const {
  require_at_least_one(num_keyframes, "num_keyframes");
  require_at_least_one(num_scans_averaged, "num_scans_averaged");
  require_positive(keyframe_distance_m, "keyframe_distance_m");
  require_positive(keyframe_turn_rad, "keyframe_turn_rad");
  surfaces.validate();
  image.validate();
  refinement.validate();
  corridor.validate();
  recovery.validate();
  long_steps.validate();
  votes.validate();
  gap.validate();
  gyro.validate();
  odometry.validate();
  deskew.validate();
  jolts.validate();
  trust_in_odometry.validate("trust_in_odometry");
  trust_in_last_motion.validate("trust_in_last_motion");
  require_finite(lost_below_score, "lost_below_score");
  require_at_least_one(max_lost_scans, "max_lost_scans");
  require_at_least_one(min_points, "min_points");
}

}  // namespace setsquare
