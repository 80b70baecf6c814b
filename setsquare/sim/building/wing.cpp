// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/building/wing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "setsquare/core/angle.hpp"
#include "setsquare/sim/building/furnishing.hpp"
#include "setsquare/sim/building/openings.hpp"
#include "setsquare/sim/building/visits.hpp"

namespace setsquare {
namespace {

ConvexPolygon corridor_outline(const Wing& wing) {
  return rectangle(wing.T_map_wing, 0.0, -wing.half_width_m, wing.length_m, wing.half_width_m);
}

/// A visit in the direction of travel, with where it leaves the corridor and comes back.
struct VisitOnTheWay {
  double in_x_m;
  std::vector<Eigen::Vector2d> corners_m;
};

/// Visits to the rooms whose doors lie between the two places.
std::vector<VisitOnTheWay> plan_visits(
    const Wing& wing, double low_x_m, double high_x_m, bool is_forward, Random& random) {
  constexpr double kToEnd_m = 0.8;
  const Pose2 T_wing_map = wing.T_map_wing.inverse();
  std::vector<VisitOnTheWay> visits;
  for (const Room& room : wing.rooms) {
    const double door_y = (T_wing_map * room.doorways.front().T_map_wall).y_m;
    const auto visit = plan_visit(room, std::abs(door_y - wing.route_y_m), random);
    if (!visit) continue;
    std::vector<Eigen::Vector2d> corners = visit->corners_m;
    double in_x = (T_wing_map * corners.front()).x();
    double out_x = (T_wing_map * corners.back()).x();
    if (std::min(in_x, out_x) < low_x_m + kToEnd_m || std::max(in_x, out_x) > high_x_m - kToEnd_m)
      continue;
    if ((out_x < in_x) == is_forward) {
      std::reverse(corners.begin(), corners.end());
      std::swap(in_x, out_x);
    }
    visits.push_back({in_x, corners});
  }
  return visits;
}

}  // namespace

double length_of(const std::vector<Eigen::Vector2d>& route_m) {
  double length = 0.0;
  for (std::size_t i = 1; i < route_m.size(); ++i) length += (route_m[i] - route_m[i - 1]).norm();
  return length;
}

Wing make_wing(const Pose2& T_map_wing, double length_m, Random& random) {
  Wing wing;
  wing.T_map_wing = T_map_wing;
  wing.length_m = length_m;
  wing.half_width_m = random.uniform(0.85, 1.3);
  wing.route_y_m = random.uniform(-0.25, 0.25) * wing.half_width_m;
  wing.rows.depth_m = random.uniform(3.8, 6.5);
  return wing;
}

void add_wing_corridor(BuildingSketch& sketch, const Wing& wing, Random& random) {
  sketch.spaces.push_back({corridor_outline(wing), {}});
  const Pose2 end = wing.T_map_wing * Pose2{wing.length_m, random.uniform(-0.15, 0.15), 0.0};
  const double width = random.uniform(0.5, 0.75) * 2.0 * wing.half_width_m;
  const double kind = random.uniform();
  if (kind < 0.4) add_closed_door(sketch, end, width, random.uniform(0.05, 0.2));
  if (kind > 0.6) add_window(sketch, end, width, random.uniform(0.08, 0.2));
}

void add_wing_rooms(BuildingSketch& sketch, Wing& wing, Random& random) {
  RoomRow left = wing.rows;
  left.T_map_row = wing.T_map_wing * Pose2{wing.rows_from_m, wing.half_width_m, 0.0};
  left.length_m = wing.length_m - wing.rows_from_m;
  RoomRow right = wing.rows;
  right.T_map_row = wing.T_map_wing * Pose2{wing.length_m, -wing.half_width_m, kPi};
  right.length_m = left.length_m;
  right.depth_m *= random.uniform(0.8, 1.2);
  for (const RoomRow& row : {left, right}) {
    std::vector<Room> rooms = add_room_row(sketch, row, random);
    std::move(rooms.begin(), rooms.end(), std::back_inserter(wing.rooms));
  }
}

void append_wing_route(BuildingSketch& sketch,
                       const Wing& wing,
                       double from_x_m,
                       double to_x_m,
                       double longest_m,
                       Random& random) {
  const bool is_forward = from_x_m < to_x_m;
  std::vector<VisitOnTheWay> visits =
      plan_visits(wing, std::min(from_x_m, to_x_m), std::max(from_x_m, to_x_m), is_forward, random);
  double length = length_of(sketch.route_m) + std::abs(to_x_m - from_x_m);
  while (!visits.empty()) {
    double visit_length = 0.0;
    for (const VisitOnTheWay& visit : visits) visit_length += length_of(visit.corners_m);
    if (length + visit_length <= longest_m) break;
    const int victim = random.integer(0, static_cast<int>(visits.size()) - 1);
    visits.erase(visits.begin() + victim);
  }
  std::sort(visits.begin(), visits.end(), [&](const VisitOnTheWay& a, const VisitOnTheWay& b) {
    return is_forward ? a.in_x_m < b.in_x_m : a.in_x_m > b.in_x_m;
  });
  const auto on_line = [&wing](double x_m) {
    return wing.T_map_wing * Eigen::Vector2d(x_m, wing.route_y_m);
  };
  sketch.route_m.push_back(on_line(from_x_m));
  for (const VisitOnTheWay& visit : visits)
    sketch.route_m.insert(sketch.route_m.end(), visit.corners_m.begin(), visit.corners_m.end());
  sketch.route_m.push_back(on_line(to_x_m));
}

void furnish_wing(BuildingSketch& sketch, const Wing& wing, Random& random) {
  for (const Room& room : wing.rooms) furnish(sketch, room);
  const auto seed = static_cast<std::uint64_t>(random.integer(0, 1 << 30));
  furnish(sketch, {corridor_outline(wing), RoomUse::kCorridor, seed, {}});
  for (const Room& room : wing.rooms)
    if (random.chance(0.4)) add_people(sketch, room.outline, random.integer(1, 2), 0.4, random);
  const int num_in_corridor =
      static_cast<int>(random.uniform(0.0, 2.0) * wing.people_per_m * wing.length_m);
  add_people(sketch, corridor_outline(wing), num_in_corridor, 0.6, random);
}

}  // namespace setsquare
