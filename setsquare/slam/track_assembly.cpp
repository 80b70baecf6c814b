// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/slam/track_assembly.hpp"

namespace setsquare {
namespace {

/// The pose `share` of the way from a to b.
Pose2 between(const Pose2& a, const Pose2& b, double share) {
  return {a.x_m + share * (b.x_m - a.x_m),
          a.y_m + share * (b.y_m - a.y_m),
          wrap_to_pi(a.theta_rad + share * wrap_to_pi(b.theta_rad - a.theta_rad))};
}

}  // namespace

std::vector<Pose2> assemble_track(std::span<const Pose2> T_odom_sensor,
                                  std::span<const MappedKeyframe> keyframes) {
  std::vector<Pose2> T_map_sensor(T_odom_sensor.begin(), T_odom_sensor.end());
  if (keyframes.empty()) return T_map_sensor;
  const auto seen_from = [&](const MappedKeyframe& keyframe, std::size_t i) {
    return keyframe.T_map_sensor *
           (T_odom_sensor[keyframe.scan_index].inverse() * T_odom_sensor[i]);
  };
  for (std::size_t i = 0; i < keyframes.front().scan_index; ++i) {
    T_map_sensor[i] = seen_from(keyframes.front(), i);
  }
  for (std::size_t k = 0; k < keyframes.size(); ++k) {
    const MappedKeyframe& from = keyframes[k];
    const bool is_last = k + 1 == keyframes.size();
    const std::size_t end = is_last ? T_odom_sensor.size() : keyframes[k + 1].scan_index;
    const bool hangs = is_last || keyframes[k + 1].begins_piece;
    const MappedKeyframe& to = hangs ? from : keyframes[k + 1];
    for (std::size_t i = from.scan_index; i < end; ++i) {
      const double share =
          static_cast<double>(i - from.scan_index) / static_cast<double>(end - from.scan_index);
      T_map_sensor[i] = between(seen_from(from, i), seen_from(to, i), share);
    }
  }
  return T_map_sensor;
}

}  // namespace setsquare
