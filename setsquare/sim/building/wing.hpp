// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "setsquare/sim/building/rooms.hpp"
#include "setsquare/sim/random.hpp"

namespace setsquare {

/// A corridor with rooms on both sides. In its frame it runs along x from 0.
struct Wing {
  Pose2 T_map_wing;
  double length_m = 0.0;
  double half_width_m = 1.1;
  double rows_from_m = 0.3;    ///< Where the rooms begin.
  double route_y_m = 0.0;      ///< Where in the corridor the robot drives.
  double people_per_m = 0.08;  ///< In the corridor, on the average of buildings.
  RoomRow rows;                ///< Depth, widths and shares of both rows.
  std::vector<Room> rooms;     ///< Those that are open; filled in by add_wing_rooms.
};

/// A corridor in a random width, with its route off the middle.
[[nodiscard]] Wing make_wing(const Pose2& T_map_wing, double length_m, Random& random);

/// Adds the corridor itself, its far end closed by a wall, a door or a window.
void add_wing_corridor(BuildingSketch& sketch, const Wing& wing, Random& random);

/// Adds the rooms on both sides, where the spaces so far leave room. Comes after all corridors.
void add_wing_rooms(BuildingSketch& sketch, Wing& wing, Random& random);

/// Drives along the corridor from one place to another, with visits to rooms on the way as long as
/// the whole route stays below `longest_m`.
void append_wing_route(BuildingSketch& sketch,
                       const Wing& wing,
                       double from_x_m,
                       double to_x_m,
                       double longest_m,
                       Random& random);

/// Furniture and people in the rooms and the corridor. Comes after the route.
void furnish_wing(BuildingSketch& sketch, const Wing& wing, Random& random);

/// Length of a polyline.
[[nodiscard]] double length_of(const std::vector<Eigen::Vector2d>& route_m);

}  // namespace setsquare
