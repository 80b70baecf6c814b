// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/building/visits.hpp"

#include <algorithm>

namespace setsquare {
namespace {

constexpr double kBehindDoor_m = 0.75;  // Straight on through the door before the first turn.

/// A place in the room to drive to, deeper in the room than the end of the doorway.
std::optional<Eigen::Vector2d> draw_stop(const Room& room,
                                         const std::vector<Eigen::Vector2d>& corners_m,
                                         Random& random) {
  constexpr double kStopToWall_m = 0.8;
  constexpr double kBetweenStops_m = 0.9;
  constexpr int kTries = 60;
  Eigen::Array2d low = room.outline.front(), high = low;
  for (const Eigen::Vector2d& corner : room.outline) {
    low = low.min(corner.array());
    high = high.max(corner.array());
  }
  const Pose2 T_wall_map = room.doorways.front().T_map_wall.inverse();
  const double inside_x = room.doorways.front().thickness_m + kBehindDoor_m;
  for (int i = 0; i < kTries; ++i) {
    const double x = random.uniform(low.x(), high.x());
    const double y = random.uniform(low.y(), high.y());
    const Eigen::Vector2d stop(x, y);
    if (!contains(room.outline, stop, kStopToWall_m)) continue;
    if ((T_wall_map * stop).x() < inside_x) continue;
    if (std::all_of(corners_m.begin(), corners_m.end(), [&stop](const Eigen::Vector2d& other) {
          return (other - stop).norm() >= kBetweenStops_m;
        }))
      return stop;
  }
  return std::nullopt;
}

}  // namespace

std::optional<RoomVisit> plan_visit(const Room& room, double approach_m, Random& random) {
  if (room.doorways.empty()) return std::nullopt;
  RoomVisit visit;
  const auto at = [](const Doorway& door, double x_m) {
    return door.T_map_wall * Eigen::Vector2d(x_m, 0.0);
  };
  const Doorway& in = room.doorways.front();
  const Doorway& out = room.doorways.back();
  visit.corners_m = {at(in, -approach_m), at(in, in.thickness_m + kBehindDoor_m)};
  const Eigen::Vector2d last_in_room = at(out, out.thickness_m + kBehindDoor_m);
  if (!contains(room.outline, visit.corners_m.back(), 0.4) ||
      !contains(room.outline, last_in_room, 0.4))
    return std::nullopt;
  for (int num_stops = random.integer(2, 3); num_stops > 0; --num_stops) {
    const auto stop = draw_stop(room, visit.corners_m, random);
    if (!stop) break;
    visit.corners_m.push_back(*stop);
  }
  if (visit.corners_m.size() < 3) return std::nullopt;
  visit.corners_m.push_back(last_in_room);
  visit.corners_m.push_back(at(out, -approach_m));
  return visit;
}

}  // namespace setsquare
