// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/motion_prediction.hpp"

#include <cassert>

namespace setsquare {

void MotionPrediction::add(const Pose2& T_odom_sensor,
                           const std::optional<Pose2>& T_wheels_sensor) {
  poses_.push_back(T_odom_sensor);
  if (poses_.size() > num_scans_averaged_ + 1) poses_.pop_front();
  T_wheels_sensor_ = T_wheels_sensor;
}

void MotionPrediction::restart() { poses_.erase(poses_.begin(), poses_.end() - 1); }

Pose2 MotionPrediction::next_by_last_motion() const {
  assert(!poses_.empty());
  if (poses_.size() < 2) return poses_.back();
  const Pose2& last = poses_.back();
  const Pose2 T_first_last = poses_.front().inverse() * last;
  const double share = 1.0 / static_cast<double>(poses_.size() - 1);
  const double turn_rad = wrap_to_pi(last.theta_rad - poses_[poses_.size() - 2].theta_rad);
  // The chord of an arc points half the turn away from its tangents: from the middle of the motion
  // so far to the middle of the next one.
  const Pose2 chord{T_first_last.x_m * share, T_first_last.y_m * share, 0.0};
  const Pose2 turned = Pose2{0.0, 0.0, 0.5 * turn_rad - 0.5 * T_first_last.theta_rad} * chord;
  return last * Pose2{turned.x_m, turned.y_m, turn_rad};
}

Pose2 MotionPrediction::next(const std::optional<Pose2>& T_wheels_sensor) const {
  if (!has_odometry(T_wheels_sensor)) return next_by_last_motion();
  return poses_.back() * (T_wheels_sensor_->inverse() * *T_wheels_sensor);
}

}  // namespace setsquare
