// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/building/furnishing.hpp"
#include "setsquare/sim/building/openings.hpp"
#include "setsquare/sim/building/wing.hpp"

// The building of section 5.2, as far as the paper's text describes it: 136 x 236 m, a track of
// 1124 m from (0, 0), circuits from D = (85, 33) of 398 m and from G = (83, -19) of 901 m with
// their orders of places. The rest is our reconstruction: A, B, C, D are the corners of a rectangle
// of corridors, an inner corridor joins C to B by a second way of the same length, F lies below B.
// Where the corridors run is given to the decimetre by those lengths.

namespace setsquare {
namespace {

/// A straight corridor; rooms of these depths to its left and right, seen from `from_m`.
struct Corridor {
  double from_x_m, from_y_m, to_x_m, to_y_m;
  double half_width_m;
  double left_depth_m, right_depth_m;
};

constexpr double kTop_m = 105.15;    // Of A and C.
constexpr double kLeft_m = -42.1;    // Of A and B.
constexpr double kFLeft_m = -42.95;  // Of F, a little beyond B.
constexpr double kFarRight_m = 183.0;

constexpr Corridor kCorridors[] = {
    {-47.0, kTop_m, 86.4, kTop_m, 1.3, 3.0, 5.5},            // A - C
    {kLeft_m, 31.7, kLeft_m, 110.0, 1.2, 3.1, 5.0},          // B - A
    {kFLeft_m, -26.0, kFLeft_m, 34.2, 1.2, 2.4, 5.2},        // F - B
    {-44.1, 33.0, 86.3, 33.0, 1.2, 5.6, 5.2},                // B - D
    {30.0, 32.0, 30.0, 106.0, 1.1, 4.8, 5.4},                // the inner way from C to B
    {85.0, -20.3, 85.0, 106.4, 1.4, 5.5, 6.2},               // G - D - C
    {-44.0, -19.0, 189.0, -19.0, 1.3, 5.5, 5.1},             // F - G and on to the end
    {kFarRight_m, -20.2, kFarRight_m, 10.0, 1.2, 5.0, 4.2},  // the end
    {0.0, -20.0, 0.0, 2.5, 1.1, 4.5, 5.0},                   // the start
};

const std::vector<Eigen::Vector2d>& track() {
  static const std::vector<Eigen::Vector2d> corners_m = {
      {0.0, 0.0},
      {0.0, -19.0},
      {85.0, -19.0},
      {85.0, kTop_m},
      {kLeft_m, kTop_m},
      {kLeft_m, 33.0},
      {85.0, 33.0},
      {85.0, kTop_m},
      {30.0, kTop_m},
      {30.0, 33.0},
      {kFLeft_m, 33.0},
      {kFLeft_m, -19.0},
      {kFarRight_m, -19.0},
      {kFarRight_m, 2.4},
  };
  return corners_m;
}

Wing make_corridor(const Corridor& corridor) {
  Wing wing;
  const Eigen::Vector2d from(corridor.from_x_m, corridor.from_y_m);
  const Eigen::Vector2d way = Eigen::Vector2d(corridor.to_x_m, corridor.to_y_m) - from;
  wing.T_map_wing = {from.x(), from.y(), std::atan2(way.y(), way.x())};
  wing.length_m = way.norm();
  wing.half_width_m = corridor.half_width_m;
  wing.people_per_m = 0.02;
  return wing;
}

/// Rooms on both sides; rooms that would overlap another corridor are left out.
void add_rooms(BuildingSketch& sketch, const Corridor& corridor, Wing& wing, Random& random) {
  RoomRow row;
  row.length_m = wing.length_m;
  row.open_share = random.uniform(0.3, 0.5);
  row.bare_share = random.uniform(0.1, 0.25);
  row.min_width_m = 2.6;
  row.max_width_m = 7.5;
  for (const bool is_left : {true, false}) {
    row.depth_m = is_left ? corridor.left_depth_m : corridor.right_depth_m;
    const Pose2 T_wing_row = is_left ? Pose2{0.0, wing.half_width_m, 0.0}
                                     : Pose2{wing.length_m, -wing.half_width_m, kPi};
    row.T_map_row = wing.T_map_wing * T_wing_row;
    std::vector<Room> rooms = add_room_row(sketch, row, random);
    std::move(rooms.begin(), rooms.end(), std::back_inserter(wing.rooms));
  }
}

/// A hall where corridors meet, about the corner of the way and wider than they are.
ConvexPolygon draw_hall(const Eigen::Vector2d& corner_m, Random& random) {
  const double left = random.uniform(2.0, 4.0);
  const double down = random.uniform(2.0, 4.0);
  const double right = random.uniform(2.0, 3.5);
  const double up = random.uniform(2.0, 3.5);
  return rectangle({corner_m.x(), corner_m.y(), 0.0}, -left, -down, right, up);
}

double distance_to_corner(std::size_t corner) {
  const auto& corners_m = track();
  return length_of(
      {corners_m.begin(), corners_m.begin() + static_cast<std::ptrdiff_t>(corner) + 1});
}

std::array<Circuit, 2> circuits() {
  constexpr double kGToCorner_m = 2.0;  // G = (83, -19) lies before the corner at (85, -19).
  const double first_d = distance_to_corner(2) + 52.0;  // On the way up from (85, -19).
  const double g = distance_to_corner(2) - kGToCorner_m;
  const double g_again = distance_to_corner(11) + 83.0 - kFLeft_m;
  return {Circuit{first_d, distance_to_corner(6), "DCABD"}, Circuit{g, g_again, "GDCABDCBFG"}};
}

}  // namespace

PaperBuilding make_paper_building(std::uint64_t seed) {
  Random random(sub_seed(seed, 101));
  BuildingSketch sketch;
  std::vector<Wing> wings;
  for (const Corridor& corridor : kCorridors) {
    wings.push_back(make_corridor(corridor));
    add_wing_corridor(sketch, wings.back(), random);
  }
  std::vector<ConvexPolygon> halls;
  for (const Eigen::Vector2d& corner : {track()[2], track()[3], track()[5], track()[6]}) {
    halls.push_back(draw_hall(corner, random));
    sketch.spaces.push_back({halls.back(), {}});
  }
  for (std::size_t i = 0; i < wings.size(); ++i) add_rooms(sketch, kCorridors[i], wings[i], random);
  sketch.route_m = track();
  hang_leaves(sketch, random);
  for (const ConvexPolygon& hall : halls) {
    const auto hall_seed = static_cast<std::uint64_t>(random.integer(0, 1 << 30));
    furnish(sketch, {hall, RoomUse::kHall, hall_seed, {}});
  }
  for (const Wing& wing : wings) furnish_wing(sketch, wing, random);
  return {finish(sketch, 0.0), circuits()};
}

}  // namespace setsquare
