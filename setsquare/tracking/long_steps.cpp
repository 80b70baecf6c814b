// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/long_steps.hpp"

#include <cmath>

#include "setsquare/core/parameter_checks.hpp"

namespace setsquare {

void LongStepParams::validate() const {
  require_positive(long_m, "long_steps.long_m");
  require_positive(long_rad, "long_steps.long_rad");
  require_at_least_one(num_steps, "long_steps.num_steps");
  require_at_least_one(min_long, "long_steps.min_long");
}

void LongSteps::add(const Pose2& step) {
  const bool is_long = std::hypot(step.x_m, step.y_m) > params_.long_m ||
                       std::abs(step.theta_rad) > params_.long_rad;
  are_long_.push_back(is_long);
  num_long_ += is_long ? 1 : 0;
  if (are_long_.size() <= params_.num_steps) return;
  num_long_ -= are_long_.front() ? 1 : 0;
  are_long_.pop_front();
}

}  // namespace setsquare
