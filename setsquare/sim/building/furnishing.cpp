// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/building/furnishing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "setsquare/core/angle.hpp"
#include "setsquare/sim/building/floor.hpp"
#include "setsquare/sim/building/furniture.hpp"
#include "setsquare/sim/building/rooms.hpp"

namespace setsquare {
namespace {

/// How a room of one use is furnished. Shares are chances for each piece along a wall; what is left
/// to 1 are gaps.
struct Furnishing {
  double cabinet_share;
  double desk_share;
  double box_share;
  double plant_share;
  double radiator_share;
  double longest_gap_m;      ///< Between pieces along a wall.
  double deepest_m;          ///< Of cabinets.
  double tables_per_m2;      ///< On the floor.
  double clutter_per_m2;     ///< Chairs, boxes, bins, plants at odd angles on the floor.
  double shelf_rows_per_m2;  ///< Shelves that stand free.
  double pillars_per_m2;
  double screens_per_m2;  ///< Thin partitions that stand free or at a wall.
};

Furnishing furnishing_for(RoomUse use) {
  switch (use) {
    case RoomUse::kOffice:
      return {0.40, 0.33, 0.08, 0.05, 0.10, 0.7, 0.60, 0.02, 0.12, 0.02, 0.003, 0.06};
    case RoomUse::kMeeting:
      return {0.30, 0.05, 0.10, 0.10, 0.15, 1.4, 0.55, 0.07, 0.14, 0.00, 0.003, 0.04};
    case RoomUse::kStore:
      return {0.62, 0.03, 0.28, 0.00, 0.03, 0.4, 0.80, 0.01, 0.18, 0.08, 0.003, 0.02};
    case RoomUse::kCorridor:
      return {0.30, 0.00, 0.18, 0.10, 0.10, 6.0, 0.42, 0.00, 0.02, 0.00, 0.000, 0.00};
    case RoomUse::kHall:
      return {0.45, 0.05, 0.20, 0.08, 0.05, 2.0, 0.90, 0.03, 0.12, 0.06, 0.015, 0.05};
    case RoomUse::kRound:
      return {0.45, 0.05, 0.18, 0.12, 0.03, 1.0, 0.60, 0.04, 0.22, 0.03, 0.015, 0.10};
  }
  return {};
}

/// One piece at a wall; returns how much of the wall it took, 0 if nothing was placed.
double place_at_wall(BuildingSketch& sketch,
                     RoomFloor& floor,
                     const Pose2& T_map_wall,
                     const Furnishing& furnishing,
                     Random& random) {
  double u = random.uniform();
  const double width = random.uniform(0.4, 1.7);
  const double depth = random.uniform(0.3, furnishing.deepest_m);
  const Pose2 T_map_crooked = T_map_wall * Pose2{0.0, 0.02, rad_from_deg(random.uniform(0.0, 2.5))};
  if ((u -= furnishing.cabinet_share) < 0.0)
    return place_cabinet(sketch, floor, T_map_crooked, width, depth) ? width : 0.0;
  if ((u -= furnishing.desk_share) < 0.0)
    return place_desk(sketch, floor, T_map_crooked, 0.8 + 0.5 * width, random) ? 0.8 + 0.5 * width
                                                                               : 0.0;
  const double size = random.uniform(0.2, 0.55);
  const double turn = random.uniform(-kPi, kPi);
  const Pose2 T_map_center = T_map_wall * Pose2{0.75 * size, 0.75 * size, turn};
  if ((u -= furnishing.box_share) < 0.0) {
    const double other_size = size * random.uniform(0.6, 1.0);
    return place_box(sketch, floor, T_map_center, size, other_size) ? 1.5 * size : 0.0;
  }
  if ((u -= furnishing.plant_share) < 0.0)
    return place_plant(sketch, floor, T_map_center, 0.5 * size, random) ? 1.5 * size : 0.0;
  if ((u -= furnishing.radiator_share) < 0.0)
    return place_radiator(sketch, floor, T_map_wall, width) ? width : 0.0;
  return 0.0;
}

void furnish_walls(BuildingSketch& sketch,
                   RoomFloor& floor,
                   const Furnishing& furnishing,
                   Random& random) {
  const ConvexPolygon outline = floor.outline();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d side = outline[(i + 1) % outline.size()] - outline[i];
    const double heading = std::atan2(side.y(), side.x());
    double x = random.uniform(0.02, 0.5);
    while (x < side.norm() - 0.3) {
      const Eigen::Vector2d start = outline[i] + x * side.normalized();
      const double taken =
          place_at_wall(sketch, floor, {start.x(), start.y(), heading}, furnishing, random);
      const double gap = furnishing.longest_gap_m * random.uniform();
      x += taken + (taken > 0.0 && random.chance(0.35) ? 0.02 : 0.15 + gap);
    }
  }
}

Pose2 draw_place(const ConvexPolygon& outline, Random& random) {
  Eigen::Array2d low = outline.front(), high = low;
  for (const Eigen::Vector2d& corner : outline) {
    low = low.min(corner.array());
    high = high.max(corner.array());
  }
  const double x = random.uniform(low.x(), high.x());
  const double y = random.uniform(low.y(), high.y());
  return {x, y, random.uniform(-kPi, kPi)};
}

double area_of(const ConvexPolygon& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

/// Calls `place` at random places until it succeeded per_m2 * area times, or failed too often.
template <typename Place>
void scatter(const ConvexPolygon& outline, double per_m2, Random& random, const Place& place) {
  constexpr int kTries = 12;
  const double expected = per_m2 * area_of(outline) * random.uniform(0.6, 1.4);
  const int count = static_cast<int>(expected + random.uniform());
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < kTries; ++k)
      if (place(draw_place(outline, random))) break;
}

bool place_any_clutter(BuildingSketch& sketch,
                       RoomFloor& floor,
                       const Pose2& T_map_center,
                       Random& random) {
  const double u = random.uniform();
  const double size = random.uniform(0.2, 0.7);
  if (u < 0.4) return place_chair(sketch, floor, T_map_center, random);
  if (u < 0.85)
    return place_box(sketch, floor, T_map_center, size, size * random.uniform(0.5, 1.0));
  return place_plant(sketch, floor, T_map_center, 0.4 * size, random);
}

/// Most tables and shelves stand parallel to a wall of the room, some do not.
Pose2 turned_to_walls(const Pose2& place, double square_heading_rad, Random& random) {
  if (random.chance(0.25)) return place;
  const double crooked = rad_from_deg(1.5) * random.normal();
  const double quarter = random.chance(0.5) ? 0.5 * kPi : 0.0;
  return {place.x_m, place.y_m, square_heading_rad + quarter + crooked};
}

/// A shelf or a screen that stands free.
bool place_free(BuildingSketch& sketch, RoomFloor& floor, const ConvexPolygon& outline) {
  if (!floor.take(outline)) return false;
  add_outline(sketch, outline, Material::kFurniture);
  return true;
}

void furnish_floor(BuildingSketch& sketch,
                   RoomFloor& floor,
                   const Furnishing& furnishing,
                   Random& random) {
  const ConvexPolygon outline = floor.outline();
  const Eigen::Vector2d side = outline[1] - outline[0];
  const double heading = std::atan2(side.y(), side.x());
  scatter(outline, furnishing.pillars_per_m2, random, [&](const Pose2& place) {
    const double size = random.uniform(0.3, 0.7);
    const bool is_round = random.chance(0.4);
    return place_pillar(sketch, floor, {place.x_m, place.y_m, heading}, size, is_round);
  });
  scatter(outline, furnishing.shelf_rows_per_m2, random, [&](const Pose2& place) {
    const double length = random.uniform(1.2, 5.0);
    const double width = random.uniform(0.35, 0.9);
    const Pose2 turned = turned_to_walls(place, heading, random);
    return place_free(sketch, floor, box(turned, length, width));
  });
  scatter(outline, furnishing.screens_per_m2, random, [&](const Pose2& place) {
    const Pose2 turned = turned_to_walls(place, heading, random);
    return place_free(sketch, floor, box(turned, random.uniform(1.2, 3.0), 0.05));
  });
  scatter(outline, furnishing.tables_per_m2, random, [&](const Pose2& place) {
    const double length = random.uniform(1.0, 2.4);
    const double width = random.uniform(0.7, 1.1);
    const Pose2 turned = turned_to_walls(place, heading, random);
    return place_table(sketch, floor, turned, length, width, random);
  });
  scatter(outline, furnishing.clutter_per_m2, random, [&](const Pose2& place) {
    return place_any_clutter(sketch, floor, place, random);
  });
}

}  // namespace

void furnish(BuildingSketch& sketch, const Room& room) {
  Random random(room.furnishing_seed);
  RoomFloor floor(sketch, room.outline);
  const Furnishing furnishing = furnishing_for(room.use);
  if (room.use == RoomUse::kRound) add_partitions(sketch, floor, 16, 3.6, random);
  if (room.use == RoomUse::kHall) add_partitions(sketch, floor, 16, 5.0, random);
  furnish_walls(sketch, floor, furnishing, random);
  furnish_floor(sketch, floor, furnishing, random);
}

void add_people(BuildingSketch& sketch,
                const ConvexPolygon& outline,
                int num_people,
                double walking_share,
                Random& random) {
  constexpr double kToRoute_m = 0.45;
  constexpr double kShoulders_m = 0.44;
  constexpr int kTries = 25;
  RoomFloor floor(sketch, outline);
  const Eigen::Vector2d side = outline[1] - outline[0];
  const double along = std::atan2(side.y(), side.x());
  for (int i = 0; i < num_people; ++i) {
    const bool is_walking = random.chance(walking_share);
    for (int k = 0; k < kTries; ++k) {
      const double length = is_walking ? random.uniform(1.5, 9.0) : 0.0;
      Pose2 middle = draw_place(outline, random);
      // Most walk along the room, as one does in a corridor.
      if (random.chance(0.6)) middle.theta_rad = along + 0.05 * random.normal();
      const ConvexPolygon lane = box(middle, length + kShoulders_m, kShoulders_m);
      if (!floor.take(lane, kToRoute_m)) continue;
      const double speed = random.uniform(0.7, 1.5);
      const double phase = random.uniform(0.0, 20.0);
      sketch.people.push_back({middle * Eigen::Vector2d(-0.5 * length, 0.0),
                               middle * Eigen::Vector2d(0.5 * length, 0.0),
                               speed,
                               phase});
      break;
    }
  }
}

}  // namespace setsquare
