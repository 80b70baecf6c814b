// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/trajectory.hpp"
#include "setsquare/map/map.hpp"

namespace setsquare {

/// The way that a robot drove, a pose every 0.1 m or 5 degrees.
class DrivenWay {
 public:
  /// Beyond `max_poses` the oldest are forgotten.
  explicit DrivenWay(std::size_t max_poses = std::numeric_limits<std::size_t>::max())
      : max_poses_(max_poses) {}

  /// Returns whether the pose is one of the way's.
  bool add(const StampedPose& at) {
    if (!poses_.empty() && !has_moved_on(poses_.back().pose, at.pose)) return false;
    if (poses_.size() >= max_poses_) {  // Many at once: it happens rarely.
      poses_.erase(poses_.begin(),
                   poses_.begin() + static_cast<std::ptrdiff_t>(max_poses_ / 4 + 1));
    }
    poses_.push_back(at);
    return true;
  }

  [[nodiscard]] const Trajectory& poses() const { return poses_; }

 private:
  static bool has_moved_on(const Pose2& from, const Pose2& to) {
    constexpr double kSpacing_m = 0.1;
    constexpr double kTurn_rad = rad_from_deg(5.0);
    const Pose2 moved = from.inverse() * to;
    return std::hypot(moved.x_m, moved.y_m) >= kSpacing_m || std::abs(moved.theta_rad) >= kTurn_rad;
  }

  std::size_t max_poses_;
  Trajectory poses_;
};

/// The robot's, as far as the map knows it.
[[nodiscard]] inline Trajectory way_of(const Map& map) {
  DrivenWay way;
  for (const MappedScan& scan : map.scans) {
    if (scan.is_placed) way.add({scan.stamp, scan.T_map_base});
  }
  return way.poses();
}

}  // namespace setsquare
