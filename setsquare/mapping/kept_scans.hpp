// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/tracking/tracked_pose.hpp"

namespace setsquare {

/// Chooses the scans that a map keeps whole: the keyframes, and those that moved on by 0.1 m or 5
/// degrees since the last one kept. Memory grows with the way driven, not with the time. Shared by
/// Mapper and PaperMapper.
class KeptScans {
 public:
  /// The next scan. `share`: gives it as a shared pointer; called only where it is kept.
  template <typename Share>
  void add(const TrackedPose& tracked, const Share& share) {
    constexpr double kSpacing_m = 0.1;
    constexpr double kTurn_rad = rad_from_deg(5.0);
    const std::size_t index = num_scans_++;
    if (!kept_.empty() && !tracked.is_keyframe) {
      const Pose2 moved = T_odom_last_.inverse() * tracked.T_odom_sensor;
      if (std::hypot(moved.x_m, moved.y_m) < kSpacing_m && std::abs(moved.theta_rad) < kTurn_rad) {
        return;
      }
    }
    T_odom_last_ = tracked.T_odom_sensor;
    kept_.push_back({index, share()});
  }

  [[nodiscard]] const std::vector<KeptScan>& kept() const { return kept_; }

 private:
  std::vector<KeptScan> kept_;
  Pose2 T_odom_last_;
  std::size_t num_scans_ = 0;
};

}  // namespace setsquare
