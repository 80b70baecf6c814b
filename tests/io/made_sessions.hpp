// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from made_map, its only user, because that is long enough.
#pragma once

#include <cstddef>

#include "setsquare/map/map.hpp"

namespace setsquare::testing {

/// Two sessions, and the track, of a map that has its scans and keyframes. To be drawn after all
/// others, so that what they draw stays as it was.
template <typename Draw>
void draw_sessions(Draw& draw, Map& map) {
  const std::size_t half = map.scans.size() / 2;
  map.sessions = {{0, half, 4, {}}, {half, map.scans.size() - half, draw.below(9), {1, 2, 3}}};
  for (std::size_t i = 0; i < map.scans.size(); ++i) map.track.T_odom_sensor.push_back(draw.pose());
  for (std::size_t k = 0; k < map.keyframes.size(); ++k) {
    MotionCovariance c{.open_stretch = k, .has_odometry = draw.coin(), .is_long_step = draw.coin()};
    for (double& value : c.translation_m2.reshaped()) value = draw.number();
    for (double& value : c.open_sigma_m.reshaped()) value = draw.number();
    for (double* value : {&c.rotation_rad2, &c.slip_sigma_m}) *value = draw.number();
    map.track.motions.push_back({draw.pose(), c, draw.below(9), draw.share()});
  }
}

/// Every field, numbers bit for bit.
template <typename Listing>
void list_sessions(Listing& out, const Map& map) {
  const auto add = [&](const auto&... values) { (out.add("session", values), ...); };
  for (const auto& [first_scan, num_scans, recency, s] : map.sessions) {
    add(first_scan, num_scans, recency, s.num_pairs, s.num_matched, s.num_agreeing);
  }
  for (const Pose2& pose : map.track.T_odom_sensor) add(pose);
  for (const auto& [T_odom_body, c, stretch, share_of_place] : map.track.motions) {
    for (const double value : c.translation_m2.reshaped()) add(value);
    for (const double value : c.open_sigma_m.reshaped()) add(value);
    add(T_odom_body, stretch, share_of_place, c.rotation_rad2, c.open_stretch, c.slip_sigma_m);
    add(c.has_odometry, c.is_long_step, c.departure_sigma_m, c.departure_sigma_rad);
  }
}

}  // namespace setsquare::testing
