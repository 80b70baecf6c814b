// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/building/rooms.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "setsquare/core/angle.hpp"
#include "setsquare/sim/building/openings.hpp"

namespace setsquare {
namespace {

/// A stretch of the row between two walls, in the row's frame.
struct RowStretch {
  double start_m;
  double end_m;
  double thickness_m;  ///< Of the wall towards the corridor.
  [[nodiscard]] double width_m() const { return end_m - start_m; }
};

/// A place at the row's wall.
Pose2 wall_place(const RoomRow& row, double x_m) {
  return row.T_map_row * Pose2{x_m, 0.0, 0.5 * kPi};
}

double door_position(const RowStretch& stretch, double door_width_m, Random& random) {
  const double margin = 0.5 * door_width_m + 0.12;
  const double low = stretch.start_m + margin;
  const double high = stretch.end_m - margin;
  // Mostly near a corner of the room, sometimes anywhere.
  const double position = random.uniform(low, high);
  if (random.chance(0.4)) return position;
  const double from_corner = std::min(random.uniform(0.0, 0.5), 0.5 * (high - low));
  return random.chance(0.5) ? low + from_corner : high - from_corner;
}

/// Whether there is nothing but wall behind a place at a wall.
bool is_solid(const BuildingSketch& sketch,
              const Pose2& T_map_wall,
              double width_m,
              double depth_m) {
  constexpr double kGap_m = 0.04;
  return is_unbuilt(
      sketch, rectangle(T_map_wall, kGap_m, -0.5 * width_m, depth_m, 0.5 * width_m), kGap_m);
}

/// Doors that stay closed, niches, or nothing.
void add_closed_front(BuildingSketch& sketch,
                      const RoomRow& row,
                      const RowStretch& stretch,
                      Random& random) {
  if (random.chance(row.bare_share)) return;
  const double door_width = random.uniform(0.8, 1.0);
  const double door_x = door_position(stretch, door_width, random);
  const double recess = random.uniform(0.04, stretch.thickness_m - 0.04);
  if (!is_solid(sketch, wall_place(row, door_x), door_width + 0.1, stretch.thickness_m)) return;
  add_closed_door(sketch, wall_place(row, door_x), door_width, recess);
  if (!random.chance(0.3)) return;
  const double niche_width = random.uniform(0.5, 1.4);
  const double niche_x = random.uniform(stretch.start_m + 0.8, stretch.end_m - 0.8);
  const double depth = random.uniform(0.15, 0.5);
  if (std::abs(niche_x - door_x) < 0.5 * (niche_width + door_width) + 0.15) return;
  if (is_solid(sketch, wall_place(row, niche_x), niche_width, depth + 0.1))
    add_niche(sketch, wall_place(row, niche_x), niche_width, depth);
}

/// Windows in the wall opposite to the door, irregular.
void add_outer_windows(BuildingSketch& sketch,
                       const RoomRow& row,
                       const RowStretch& stretch,
                       double outer_y_m,
                       Random& random) {
  double x = stretch.start_m + random.uniform(0.3, 0.9);
  while (true) {
    const double width = random.uniform(0.7, 1.8);
    if (x + width > stretch.end_m - 0.2) return;
    const Pose2 place = row.T_map_row * Pose2{x + 0.5 * width, outer_y_m, 0.5 * kPi};
    const double recess = random.uniform(0.08, 0.2);
    if (is_solid(sketch, place, width, 0.3)) add_window(sketch, place, width, recess);
    x += width + random.uniform(0.3, 1.6);
  }
}

Doorway add_open_door(BuildingSketch& sketch,
                      const RoomRow& row,
                      const RowStretch& stretch,
                      Random& random) {
  const double width = random.uniform(0.88, 1.0);
  const double x = door_position(stretch, width, random);
  const bool has_leaf = random.chance(0.85);
  const Doorway doorway{wall_place(row, x), width, stretch.thickness_m, has_leaf};
  add_doorway(sketch, doorway);
  return doorway;
}

RoomUse use_of_room(Random& random) {
  const double u = random.uniform();
  if (u < 0.6) return RoomUse::kOffice;
  return u < 0.8 ? RoomUse::kMeeting : RoomUse::kStore;
}

/// A room with one door, or two where it is wide, or glass towards the corridor.
Room add_open_room(BuildingSketch& sketch,
                   const RoomRow& row,
                   const RowStretch& stretch,
                   const ConvexPolygon& outline,
                   double outer_y_m,
                   Random& random) {
  sketch.spaces.push_back({outline, {}});
  Room room{outline, use_of_room(random), sub_seed(random.integer(0, 1 << 30), 0), {}};
  const bool has_two_doors = stretch.width_m() > 4.6 && random.chance(0.6);
  const bool has_glass = !has_two_doors && stretch.width_m() > 3.6 && random.chance(0.15);
  const double middle = stretch.start_m + random.uniform(0.4, 0.6) * stretch.width_m();
  RowStretch first = stretch;
  if (has_two_doors || has_glass) first.end_m = middle;
  RowStretch second = stretch;
  second.start_m = middle;
  room.doorways.push_back(add_open_door(sketch, row, first, random));
  if (has_two_doors) room.doorways.push_back(add_open_door(sketch, row, second, random));
  if (has_glass)
    add_glass_partition(sketch,
                        wall_place(row, 0.5 * (second.start_m + second.end_m)),
                        second.width_m() - 0.5,
                        stretch.thickness_m);
  add_outer_windows(sketch, row, stretch, outer_y_m, random);
  return room;
}

}  // namespace

void add_partitions(
    BuildingSketch& sketch, RoomFloor& floor, int num_tries, double longest_m, Random& random) {
  constexpr double kOffWall_m = 0.01;
  const ConvexPolygon outline = floor.outline();
  for (int i = 0; i < num_tries; ++i) {
    const int last_side = static_cast<int>(outline.size()) - 1;
    const auto k = static_cast<std::size_t>(random.integer(0, last_side));
    const Eigen::Vector2d side = outline[(k + 1) % outline.size()] - outline[k];
    const Eigen::Vector2d root = outline[k] + random.uniform(0.1, 0.9) * side;
    const double lean = rad_from_deg(random.chance(0.6) ? 0.0 : random.uniform(-25.0, 25.0));
    const double thickness = random.uniform(0.08, 0.2);
    const double length = random.uniform(0.35, 1.0) * longest_m;
    const Pose2 T_map_root{root.x(), root.y(), std::atan2(side.y(), side.x()) + 0.5 * kPi + lean};
    const double from = kOffWall_m + 0.5 * thickness * std::abs(std::tan(lean));
    const ConvexPolygon partition =
        rectangle(T_map_root, from, -0.5 * thickness, from + length, 0.5 * thickness);
    if (floor.take(partition)) add_outline(sketch, partition, Material::kWall);
  }
}

std::vector<Room> add_room_row(BuildingSketch& sketch, const RoomRow& row, Random& random) {
  std::vector<Room> rooms;
  const double thickness = random.uniform(0.12, 0.24);
  double x = random.uniform(0.1, 0.3);
  double width = 0.0;
  while (true) {
    // Now and then a room is a copy of the one before: real buildings have some of those.
    const bool is_copy = width > 0.0 && random.chance(0.2);
    const double new_width = random.uniform(row.min_width_m, row.max_width_m);
    if (!is_copy) width = new_width;
    if (x + width > row.length_m - 0.1) return rooms;
    const RowStretch stretch{x, x + width, thickness};
    const double depth = random.chance(0.8) ? row.depth_m : row.depth_m * random.uniform(0.6, 0.9);
    const double outer_y = thickness + depth;
    const ConvexPolygon outline =
        rectangle(row.T_map_row, stretch.start_m, thickness, stretch.end_m, outer_y);
    const bool is_open = random.chance(row.open_share);
    if (is_open && is_unbuilt(sketch, outline, 0.08)) {
      Room room = add_open_room(sketch, row, stretch, outline, outer_y, random);
      if (is_copy && !rooms.empty()) {
        room.use = rooms.back().use;
        room.furnishing_seed = rooms.back().furnishing_seed;
      }
      rooms.push_back(room);
    } else {
      add_closed_front(sketch, row, stretch, random);
    }
    x += width + random.uniform(0.1, 0.2);
  }
}

}  // namespace setsquare
