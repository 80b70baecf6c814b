// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// How fast a robot drives and turns.
struct RobotSpeed {
  double drive_m_per_s = 0.5;
  double turn_rad_per_s = 0.5;
  double corner_radius_m = 0.4;  ///< Corners of the route are rounded where there is room.
};

/// Where a robot is at any time: it follows a route of straight pieces, turning at the corners.
class RobotPath {
 public:
  explicit RobotPath(const std::vector<Eigen::Vector2d>& route_m, const RobotSpeed& speed = {});

  [[nodiscard]] double duration_s() const;
  [[nodiscard]] double length_m() const;
  /// T_map_base at a time; before the start and after the end the robot stands.
  [[nodiscard]] Pose2 pose_at(double time_s) const;
};

/// Times at which the robot has moved by `distance_m` or turned by `angle_rad` since the last one;
/// the first is 0.
[[nodiscard]] std::vector<double> sample_times(const RobotPath& path,
                                               double distance_m,
                                               double angle_rad);

}  // namespace setsquare
