// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/slam/scan_tracker_params.hpp"

#include <cmath>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

void require_positive(double value, const char* name) {
  if (!(value > 0.0)) throw ParameterError(name, "must be positive");
}

void require_finite(double value, const char* name) {
  if (!std::isfinite(value)) throw ParameterError(name, "must be a number");
}

void validate_refinement(const SubmapRefinementParams& refinement) {
  for (const AlignmentScale& scale : {refinement.first_step, refinement.later_steps}) {
    require_positive(scale.gate_m, "gate_m");
    require_positive(scale.scale_m, "scale_m");
  }
  if (refinement.max_iterations < 1) {
    throw ParameterError("refinement.max_iterations", "must be at least 1");
  }
  require_positive(refinement.max_step_m, "max_step_m");
}

constexpr double kMaxCorridorSteps = 10000.0;

void validate_corridor(const CorridorSearchParams& corridor) {
  require_positive(corridor.step_m, "step_m");
  require_positive(corridor.scale_m, "scale_m");
  require_positive(corridor.half_range_m, "corridor.half_range_m");
  if (!(corridor.half_range_m <= kMaxCorridorSteps * corridor.step_m)) {
    throw ParameterError("corridor.half_range_m", "must be at most 10000 steps");
  }
}

void validate_recovery(const RecoveryParams& recovery) {
  if (recovery.num_keyframes < 1) {
    throw ParameterError("recovery.num_keyframes", "must be at least 1");
  }
  require_finite(recovery.below_score, "recovery.below_score");
  require_finite(recovery.enough_score, "recovery.enough_score");
  require_finite(recovery.far_min_score, "recovery.far_min_score");
  if (!(recovery.min_gain >= 0.0)) {
    throw ParameterError("recovery.min_gain", "must not be negative");
  }
  require_positive(recovery.near_m, "recovery.near_m");
  require_positive(recovery.near_rad, "recovery.near_rad");
}

}  // namespace

void ScanTrackerParams::validate() const {
  if (num_keyframes < 1) throw ParameterError("num_keyframes", "must be at least 1");
  if (num_scans_averaged < 1) throw ParameterError("num_scans_averaged", "must be at least 1");
  require_positive(keyframe_distance_m, "keyframe_distance_m");
  require_positive(keyframe_turn_rad, "keyframe_turn_rad");
  surfaces.validate();
  validate_refinement(refinement);
  validate_corridor(corridor);
  validate_recovery(recovery);
  require_positive(trust_in_odometry.sigma_m, "trust_in_odometry.sigma_m");
  require_positive(trust_in_last_motion.sigma_m, "trust_in_last_motion.sigma_m");
  require_finite(lost_below_score, "lost_below_score");
  if (max_lost_scans < 1) throw ParameterError("max_lost_scans", "must be at least 1");
  if (min_points < 1) throw ParameterError("min_points", "must be at least 1");
}

}  // namespace setsquare
