// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/repeated_scan.hpp"

#include "setsquare/core/is_beyond.hpp"
#include "setsquare/core/same_numbers.hpp"

namespace setsquare {

bool RepeatedScan::add(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  constexpr double kLeastStep_m = 0.001;
  constexpr double kLeastTurn_rad = rad_from_deg(0.05);
  bool is_moved = false;
  if (T_wheels_base_ && T_wheels_base) {
    const Pose2 moved = T_wheels_base_->inverse() * *T_wheels_base;
    is_moved = is_beyond(moved, kLeastStep_m, kLeastTurn_rad);
  }
  T_wheels_base_ = T_wheels_base;
  is_same_ = are_same_numbers(scan.ranges_m, ranges_m_);
  if (!is_same_) ranges_m_ = scan.ranges_m;
  has_moved_ = is_same_ && (has_moved_ || is_moved);
  return has_moved_;
}

TrackedPose told_again(TrackedPose answer) {
  answer.is_same_again = true;
  answer.is_keyframe = answer.is_restart = answer.has_odometry = false;
  answer.departure = {};
  return answer;
}

}  // namespace setsquare
