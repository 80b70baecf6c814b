// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/motion_prediction.hpp"

#include <algorithm>
#include <cassert>

namespace setsquare {

void MotionPrediction::add(const Pose2& T_odom_body,
                           const std::optional<Pose2>& T_wheels_body,
                           const SweepStart& sweep) {
  Seen& seen = seen_[sweep.scanner];
  seen.period_s = seen.poses.empty() ? 0.0 : seconds_between(seen.stamp, sweep.stamp);
  seen.stamp = sweep.stamp;
  seen.poses.push_back(T_odom_body);
  if (seen.poses.size() > num_scans_averaged_ + 1) seen.poses.pop_front();
  last_scanner_ = sweep.scanner;
  T_wheels_body_ = T_wheels_body;
}

void MotionPrediction::restart() {
  std::erase_if(seen_, [&](const auto& entry) { return entry.first != last_scanner_; });
  std::deque<Pose2>& poses = seen_.at(last_scanner_).poses;
  poses.erase(poses.begin(), poses.end() - 1);
}

double MotionPrediction::share_of_period(const SweepStart& sweep) const {
  if (sweep.scanner == last_scanner_) return 1.0;
  const Seen& seen = last();
  if (!(seen.period_s > 0.0)) return 0.0;
  return std::clamp(seconds_between(seen.stamp, sweep.stamp) / seen.period_s, -1.0, 1.0);
}

Pose2 MotionPrediction::next_by_last_motion(double share_of_period,
                                            std::optional<double> gyro_turn_rad) const {
  const std::deque<Pose2>& poses = last().poses;
  assert(!poses.empty());
  if (poses.size() < 2) {
    return gyro_turn_rad ? poses.back() * Pose2{0.0, 0.0, *gyro_turn_rad} : poses.back();
  }
  const Pose2& newest = poses.back();
  const Pose2 T_first_newest = poses.front().inverse() * newest;
  const double share = share_of_period / static_cast<double>(poses.size() - 1);
  const double turn_rad = gyro_turn_rad.value_or(
      share_of_period * wrap_to_pi(newest.theta_rad - poses[poses.size() - 2].theta_rad));
  // The chord of an arc points half the turn away from its tangents: from the middle of the motion
  // so far to the middle of the next one.
  const Pose2 chord{T_first_newest.x_m * share, T_first_newest.y_m * share, 0.0};
  const Pose2 turned = Pose2{0.0, 0.0, 0.5 * turn_rad - 0.5 * T_first_newest.theta_rad} * chord;
  return newest * Pose2{turned.x_m, turned.y_m, turn_rad};
}

Pose2 MotionPrediction::next(const std::optional<Pose2>& T_wheels_body,
                             const SweepStart& sweep,
                             std::optional<double> gyro_turn_rad) const {
  if (!has_odometry(T_wheels_body)) {
    return next_by_last_motion(share_of_period(sweep), gyro_turn_rad);
  }
  return last().poses.back() * (T_wheels_body_->inverse() * *T_wheels_body);
}

}  // namespace setsquare
