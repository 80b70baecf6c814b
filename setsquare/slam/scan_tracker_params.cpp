// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/slam/scan_tracker_params.hpp"

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

void require_positive(double value, const char* name) {
  if (!(value > 0.0)) throw ParameterError(name, "must be positive");
}

}  // namespace

void ScanTrackerParams::validate() const {
  if (num_keyframes < 1) throw ParameterError("num_keyframes", "must be at least 1");
  if (num_scans_averaged < 1) throw ParameterError("num_scans_averaged", "must be at least 1");
  require_positive(keyframe_distance_m, "keyframe_distance_m");
  require_positive(keyframe_turn_rad, "keyframe_turn_rad");
  surfaces.validate();
  for (const AlignmentScale& scale : {refinement.first_step, refinement.later_steps}) {
    require_positive(scale.gate_m, "gate_m");
    require_positive(scale.scale_m, "scale_m");
  }
  require_positive(refinement.max_step_m, "max_step_m");
  require_positive(corridor.step_m, "step_m");
  require_positive(corridor.scale_m, "scale_m");
  require_positive(trust_in_odometry.sigma_m, "trust_in_odometry.sigma_m");
  require_positive(trust_in_last_motion.sigma_m, "trust_in_last_motion.sigma_m");
  if (max_lost_scans < 1) throw ParameterError("max_lost_scans", "must be at least 1");
}

}  // namespace setsquare
