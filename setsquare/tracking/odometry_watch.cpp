// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/odometry_watch.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/scan/unchanged_share.hpp"

namespace setsquare {

std::optional<Pose2> OdometryWatch::believed(const Scan& scan,
                                             const std::optional<Pose2>& T_wheels_base) {
  constexpr double kFarthest_m = 1e7;
  constexpr std::size_t kLongRest = 10;
  constexpr double kLeastUnchanged = 0.5;
  if (!T_wheels_base) return std::nullopt;
  const double distance_m = std::max(std::abs(T_wheels_base->x_m), std::abs(T_wheels_base->y_m));
  if (!(distance_m < kFarthest_m)) {
    ++num_ignored_;
    return std::nullopt;
  }
  const bool is_at_rest = rest_ && rest_->T_wheels_base == *T_wheels_base;
  if (!is_at_rest) {
    if (!rest_) rest_ = Rest{};
    rest_->scan = scan;  // its vector is used again
    rest_->T_wheels_base = *T_wheels_base;
    rest_->num_scans = 0;
    rest_->is_moved = false;
    return T_wheels_base;
  }
  ++rest_->num_scans;
  if (!rest_->is_moved && (has_hung_ || rest_->num_scans >= kLongRest)) {
    rest_->is_moved = unchanged_share(rest_->scan, scan).value_or(1.0) < kLeastUnchanged;
    has_hung_ = has_hung_ || rest_->is_moved;
  }
  if (!rest_->is_moved) return T_wheels_base;
  ++num_ignored_;
  return std::nullopt;
}

}  // namespace setsquare
