// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <map>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/pose2.hpp"
#include "setsquare/tracking/tracked_pose.hpp"

namespace setsquare {

/// Chooses the scans that a map keeps whole: the keyframes, and those that moved on by 0.1 m or 5
/// degrees since the last one kept of the same scanner. Memory grows with the way driven, not with
/// the time. Shared by LogTracker and PaperMapper.
class KeptScanChoice {
 public:
  /// Whether the next scan is one of them.
  [[nodiscard]] bool takes(const TrackedPose& tracked, std::uint32_t scanner) {
    constexpr double kSpacing_m = 0.1;
    constexpr double kTurn_rad = rad_from_deg(5.0);
    const auto [last, is_first] = T_odom_last_.try_emplace(scanner);
    if (!is_first && !tracked.is_keyframe) {
      const Pose2 moved = last->second.inverse() * tracked.T_odom_body;
      if (std::hypot(moved.x_m, moved.y_m) < kSpacing_m && std::abs(moved.theta_rad) < kTurn_rad) {
        return false;
      }
    }
    last->second = tracked.T_odom_body;
    return true;
  }

 private:
  std::map<std::uint32_t, Pose2> T_odom_last_;  ///< Of the body, by scanner.
};

}  // namespace setsquare
