// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/long_steps.hpp"

#include <algorithm>

#include "setsquare/core/parameter_checks.hpp"

namespace setsquare {

void LongStepParams::validate() const {
  require_positive(long_m, "long_steps.long_m");
  require_positive(long_rad, "long_steps.long_rad");
  require_at_least_one(num_steps, "long_steps.num_steps");
  require_at_least_one(min_long, "long_steps.min_long");
  require_positive(least_reach_m, "long_steps.least_reach_m");
  require_positive(least_reach_rad, "long_steps.least_reach_rad");
  require_positive(reach_per_step, "long_steps.reach_per_step");
}

void LongSteps::add(const Pose2& step) {
  steps_.push_back(reach_of(step));
  num_long_ += is_long(steps_.back()) ? 1 : 0;
  if (steps_.size() <= params_.num_steps) return;
  num_long_ -= is_long(steps_.front()) ? 1 : 0;
  steps_.pop_front();
}

StepReach LongSteps::reach() const {
  StepReach longest{params_.least_reach_m, params_.least_reach_rad};
  for (const StepReach& step : steps_) {
    longest.distance_m = std::max(longest.distance_m, params_.reach_per_step * step.distance_m);
    longest.turn_rad = std::max(longest.turn_rad, params_.reach_per_step * step.turn_rad);
  }
  return longest;
}

}  // namespace setsquare
