// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/slam/track_assembly.hpp"

#include <cmath>

namespace setsquare {
namespace {

std::vector<double> drift_of_every_scan(std::size_t num_scans,
                                        std::span<const DriftAtScan> drifts) {
  std::vector<double> drift_rad(num_scans, drifts.empty() ? 0.0 : drifts.front().drift_rad);
  for (std::size_t k = 0; k < drifts.size(); ++k) {
    const bool is_last = k + 1 == drifts.size();
    const DriftAtScan& from = drifts[k];
    const DriftAtScan& to = is_last ? from : drifts[k + 1];
    const std::size_t end = is_last ? num_scans : to.scan_index;
    for (std::size_t i = from.scan_index; i < end; ++i) {
      const double share =
          static_cast<double>(i - from.scan_index) / static_cast<double>(end - from.scan_index);
      drift_rad[i] = from.drift_rad + share * (to.drift_rad - from.drift_rad);
    }
  }
  return drift_rad;
}

}  // namespace

std::vector<Pose2> assemble_track(std::span<const Pose2> T_odom_sensor,
                                  std::span<const DriftAtScan> drifts) {
  const std::vector<double> drift_rad = drift_of_every_scan(T_odom_sensor.size(), drifts);
  std::vector<Pose2> T_map_sensor(T_odom_sensor.size());
  for (std::size_t i = 0; i < T_odom_sensor.size(); ++i) {
    Pose2& pose = T_map_sensor[i];
    pose.theta_rad = wrap_to_pi(T_odom_sensor[i].theta_rad + drift_rad[i]);
    if (i == 0) continue;
    const double turn_rad = 0.5 * (drift_rad[i - 1] + drift_rad[i]);
    const Eigen::Vector2d step =
        Pose2{0.0, 0.0, turn_rad} *
        Eigen::Vector2d(T_odom_sensor[i].translation() - T_odom_sensor[i - 1].translation());
    pose.x_m = T_map_sensor[i - 1].x_m + step.x();
    pose.y_m = T_map_sensor[i - 1].y_m + step.y();
  }
  return T_map_sensor;
}

}  // namespace setsquare
