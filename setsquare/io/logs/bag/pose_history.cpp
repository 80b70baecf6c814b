// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/bag/pose_history.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace setsquare {

void PoseHistory::add(Timestamp stamp, const Pose2& T_odom_base) {
  if (!poses_.empty() && seconds_between(poses_.back().stamp, stamp) < -kMaxGap_s) poses_.clear();
  auto place = poses_.end();
  while (place != poses_.begin() && std::prev(place)->stamp >= stamp) --place;
  if (place != poses_.end() && place->stamp == stamp) {
    place->T_odom_base = T_odom_base;
  } else {
    poses_.insert(place, {stamp, T_odom_base});
  }
  while (poses_.size() > kMaxPoses || seconds_between(poses_.front().stamp, stamp) > kMaxAge_s) {
    poses_.pop_front();
  }
}

std::optional<Pose2> PoseHistory::at(Timestamp stamp) const {
  const auto after =
      std::lower_bound(poses_.begin(), poses_.end(), stamp, [](const Stamped& pose, Timestamp t) {
        return pose.stamp < t;
      });
  const auto nearest_only = [stamp](const Stamped& end) -> std::optional<Pose2> {
    const double away_s = std::abs(seconds_between(end.stamp, stamp));
    if (away_s > 0.5 * kMaxGap_s) return std::nullopt;
    return end.T_odom_base;
  };
  if (poses_.empty()) return std::nullopt;
  if (after == poses_.end()) return nearest_only(poses_.back());
  if (after->stamp == stamp) return after->T_odom_base;
  if (after == poses_.begin()) return nearest_only(poses_.front());
  const Stamped& before = *std::prev(after);
  const double gap_s = seconds_between(before.stamp, after->stamp);
  const double share = seconds_between(before.stamp, stamp) / gap_s;
  if (gap_s > kMaxGap_s) return nearest_only(share < 0.5 ? before : *after);
  const Pose2& from = before.T_odom_base;
  const Pose2& to = after->T_odom_base;
  return Pose2{from.x_m + share * (to.x_m - from.x_m),
               from.y_m + share * (to.y_m - from.y_m),
               wrap_to_pi(from.theta_rad + share * wrap_to_pi(to.theta_rad - from.theta_rad))};
}

}  // namespace setsquare
