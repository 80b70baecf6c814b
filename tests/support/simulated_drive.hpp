// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/scan.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare::testing {

/// A robot's true poses on its way through the waypoints: turns on the spot, then drives straight.
inline std::vector<Pose2> drive(const std::vector<Eigen::Vector2d>& waypoints,
                                double step_m = 0.05,
                                double turn_step_rad = rad_from_deg(3.0)) {
  std::vector<Pose2> poses;
  Pose2 pose{waypoints[0].x(), waypoints[0].y(), 0.0};
  for (std::size_t w = 1; w < waypoints.size(); ++w) {
    const Eigen::Vector2d way = waypoints[w] - pose.translation();
    const double turn_rad = wrap_to_pi(std::atan2(way.y(), way.x()) - pose.theta_rad);
    const int num_turns = static_cast<int>(std::ceil(std::abs(turn_rad) / turn_step_rad));
    for (int k = 0; k < num_turns; ++k) {
      poses.push_back(pose);
      pose.theta_rad = wrap_to_pi(pose.theta_rad + turn_rad / num_turns);
    }
    const int num_steps = static_cast<int>(std::ceil(way.norm() / step_m));
    for (int k = 0; k < num_steps; ++k) {
      poses.push_back(pose);
      pose.x_m += way.x() / num_steps;
      pose.y_m += way.y() / num_steps;
    }
  }
  poses.push_back(pose);
  return poses;
}

/// One scan per pose, 0.1 s apart, each with independent noise.
inline std::vector<Scan> scans_on_drive(const std::vector<Wall>& walls,
                                        const std::vector<Pose2>& T_world_sensor,
                                        double noise_m,
                                        const Fan& fan = {}) {
  std::vector<Scan> scans;
  for (std::size_t i = 0; i < T_world_sensor.size(); ++i) {
    scans.push_back(scan_of_walls(walls, T_world_sensor[i], fan, noise_m, i + 1));
    scans.back().stamp.ns = static_cast<std::int64_t>(i) * 100'000'000;
  }
  return scans;
}

/// A way around in l_shaped_room().
inline std::vector<Eigen::Vector2d> way_around_the_room() {
  return {{1.0, 1.0}, {5.0, 1.5}, {5.5, 3.5}, {2.0, 4.0}, {2.0, 8.0}, {2.5, 3.0}, {1.0, 1.0}};
}

/// A corridor 2 m wide along x, without ends, doors or any other mark.
inline std::vector<Wall> bare_corridor() {
  return {{-100.0, -1.0, 100.0, -1.0}, {100.0, 1.0, -100.0, 1.0}};
}

/// The motion between two poses.
inline Pose2 between(const Pose2& from, const Pose2& to) { return from.inverse() * to; }

}  // namespace setsquare::testing
