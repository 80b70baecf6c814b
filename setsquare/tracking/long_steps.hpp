// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>

#include "setsquare/core/pose2.hpp"
#include "setsquare/tracking/scan_tracker_params.hpp"
#include "setsquare/tracking/step_reach.hpp"

namespace setsquare {

/// Whether a robot moves so far from scan to scan that the submap's refinement may settle at a
/// wrong place: a log of key frames, a low rate, fast turns. Counted in scans, not in seconds, for
/// such logs often have lost their stamps.
class LongSteps {
 public:
  explicit LongSteps(const LongStepParams& params) : params_(params) {}

  /// The motion from one scan to the next, where tracking knows it.
  void add(const Pose2& step);
  /// Whether many of the latest steps were long.
  [[nodiscard]] bool are_usual() const { return num_long_ >= params_.min_long; }
  /// Whether the next step may be a long one. True until enough steps are known.
  [[nodiscard]] bool are_expected() const {
    return are_usual() || steps_.size() < params_.num_steps;
  }
  /// How far the next scan may be from the last one, and turned against it.
  [[nodiscard]] StepReach reach() const;

 private:
  [[nodiscard]] bool is_long(const StepReach& step) const {
    return step.distance_m > params_.long_m || step.turn_rad > params_.long_rad;
  }

  LongStepParams params_;
  std::deque<StepReach> steps_;  ///< The latest.
  std::size_t num_long_ = 0;     ///< Of these.
};

}  // namespace setsquare
