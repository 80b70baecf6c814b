// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/sim/building/furnishing.hpp"
#include "setsquare/sim/building/layouts/layouts.hpp"
#include "setsquare/sim/building/openings.hpp"
#include "setsquare/sim/building/rooms.hpp"
#include "setsquare/sim/building/visits.hpp"
#include "setsquare/sim/building/wing.hpp"

namespace setsquare {
namespace {

/// A hall from the origin along x and y, and the rooms behind its walls.
struct Hall {
  double length_m;
  double width_m;
  std::vector<Room> side_rooms;
};

/// Rooms, closed doors and niches along one wall: `share` of the rooms are open.
void add_side(BuildingSketch& sketch,
              Hall& hall,
              const Pose2& T_map_row,
              double length_m,
              double open_share,
              Random& random) {
  RoomRow row;
  row.T_map_row = T_map_row;
  row.length_m = length_m;
  row.depth_m = random.uniform(3.5, 6.0);
  row.open_share = open_share;
  row.min_width_m = 2.8;
  row.max_width_m = 6.5;
  row.bare_share = 0.25;
  std::vector<Room> rooms = add_room_row(sketch, row, random);
  std::move(rooms.begin(), rooms.end(), std::back_inserter(hall.side_rooms));
}

Hall add_hall(BuildingSketch& sketch, Random& random) {
  Hall hall{random.uniform(18.0, 38.0), random.uniform(15.0, 24.0), {}};
  sketch.spaces.push_back({rectangle({}, 0.0, 0.0, hall.length_m, hall.width_m), {}});
  const double share = random.uniform(0.4, 0.8);
  add_side(sketch, hall, {0.0, hall.width_m, 0.0}, hall.length_m, share, random);
  add_side(sketch, hall, {hall.length_m, 0.0, kPi}, hall.length_m, 0.4 * share, random);
  add_side(sketch, hall, {0.0, 0.0, 0.5 * kPi}, hall.width_m, 0.2, random);
  add_side(sketch, hall, {hall.length_m, hall.width_m, -0.5 * kPi}, hall.width_m, 0.2, random);
  return hall;
}

/// A way about the hall, from stop to stop.
std::vector<Eigen::Vector2d> draw_stops(const Hall& hall, int num_stops, Random& random) {
  constexpr double kToWall_m = 1.4;
  constexpr double kShortest_m = 3.0;
  constexpr double kLongest_m = 8.0;
  std::vector<Eigen::Vector2d> stops;
  while (static_cast<int>(stops.size()) < num_stops) {
    const double x = random.uniform(kToWall_m, hall.length_m - kToWall_m);
    const double y = random.uniform(kToWall_m, hall.width_m - kToWall_m);
    const Eigen::Vector2d stop(x, y);
    const double step = stops.empty() ? kShortest_m : (stop - stops.back()).norm();
    if (step >= kShortest_m && step <= kLongest_m) stops.push_back(stop);
  }
  return stops;
}

/// Into the nearest of the side rooms that was not visited yet.
void append_visit(BuildingSketch& sketch, std::vector<Room>& unvisited, Random& random) {
  constexpr double kToWall_m = 1.2;
  if (unvisited.empty()) return;
  const Eigen::Vector2d here = sketch.route_m.back();
  const auto nearest =
      std::min_element(unvisited.begin(), unvisited.end(), [&here](const Room& a, const Room& b) {
        return (a.doorways.front().T_map_wall.translation() - here).norm() <
               (b.doorways.front().T_map_wall.translation() - here).norm();
      });
  const auto visit = plan_visit(*nearest, kToWall_m, random);
  unvisited.erase(nearest);
  if (!visit) return;
  sketch.route_m.insert(sketch.route_m.end(), visit->corners_m.begin(), visit->corners_m.end());
}

void add_route(BuildingSketch& sketch, const Hall& hall, Random& random) {
  constexpr double kLongest_m = 52.0;
  std::vector<Room> unvisited = hall.side_rooms;
  for (const Eigen::Vector2d& stop : draw_stops(hall, 8, random)) {
    if (length_of(sketch.route_m) > kLongest_m) return;
    sketch.route_m.push_back(stop);
    if (random.chance(0.85)) append_visit(sketch, unvisited, random);
  }
}

}  // namespace

BuildingSketch sketch_hall(Random& random) {
  BuildingSketch sketch;
  const Hall hall = add_hall(sketch, random);
  add_route(sketch, hall, random);
  hang_leaves(sketch, random);
  const auto seed = static_cast<std::uint64_t>(random.integer(0, 1 << 30));
  const ConvexPolygon outline = rectangle({}, 0.0, 0.0, hall.length_m, hall.width_m);
  furnish(sketch, {outline, RoomUse::kHall, seed, {}});
  for (const Room& room : hall.side_rooms) furnish(sketch, room);
  add_people(sketch, outline, random.integer(2, 9), 0.5, random);
  return sketch;
}

}  // namespace setsquare
