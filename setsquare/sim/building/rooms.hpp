// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "setsquare/sim/building/floor.hpp"
#include "setsquare/sim/building/sketch.hpp"
#include "setsquare/sim/random.hpp"

namespace setsquare {
/// Short walls that stand out from the sides of a room and make bays of it, clear of the route.
/// `num_tries`: how many are tried; walls without free floor are left out.
void add_partitions(
    BuildingSketch& sketch, RoomFloor& floor, int num_tries, double longest_m, Random& random);

/// The use of a room, which decides its furniture.
enum class RoomUse { kOffice, kMeeting, kStore, kCorridor, kHall, kRound };

/// A room that can be seen into.
struct Room {
  ConvexPolygon outline;
  RoomUse use = RoomUse::kOffice;
  std::uint64_t furnishing_seed = 0;
  std::vector<Doorway> doorways;  ///< Those that one can drive through.
};

/// A wall of a corridor or hall with rooms behind it.
struct RoomRow {
  /// Origin where the wall begins, x along the wall, y into it: the rooms are at y > 0.
  Pose2 T_map_row;
  double length_m = 0.0;
  double depth_m = 5.0;      ///< Of most of the rooms.
  double open_share = 0.5;   ///< Of the rooms: their doors stand open.
  double min_width_m = 2.6;  ///< Of a room, inside.
  double max_width_m = 6.5;
  double bare_share = 0.05;  ///< Of the rooms: nothing of them is seen, not even a door.
};

/// Fills the wall with rooms of irregular widths, with doors open and closed, niches and glass.
/// Rooms that have no place among the spaces so far stay closed. Returns those that are open.
[[nodiscard]] std::vector<Room> add_room_row(BuildingSketch& sketch,
                                             const RoomRow& row,
                                             Random& random);

}  // namespace setsquare
