// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/building/furniture.hpp"

#include <array>
#include <cmath>

#include "setsquare/core/angle.hpp"

namespace setsquare {
namespace {

constexpr double kBehind_m = 0.02;  // Between a piece and the wall behind it.

/// Four legs at the corners of a rectangle about a centre.
void add_legs(BuildingSketch& sketch,
              const Pose2& T_map_center,
              double length_m,
              double width_m,
              double leg_m,
              Material material) {
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5}) {
      const Pose2 T_center_leg{x * (length_m - leg_m), y * (width_m - leg_m), 0.0};
      add_outline(sketch, box(T_map_center * T_center_leg, leg_m, leg_m), material);
    }
}

bool place_closed(BuildingSketch& sketch,
                  RoomFloor& floor,
                  const ConvexPolygon& outline,
                  Material material) {
  if (!floor.take(outline)) return false;
  add_outline(sketch, outline, material);
  return true;
}

void add_star_chair(BuildingSketch& sketch, const Pose2& T_map_center, Random& random) {
  // The gas spring, and five feet that end in castors too low to be seen; some have a coat or a
  // bag hanging down at the back.
  add_outline(sketch, ellipse(T_map_center, 0.035, 0.035, 6), Material::kClutter);
  if (random.chance(0.5))
    add_outline(sketch, box(T_map_center * Pose2{-0.22, 0.0, 0.0}, 0.06, 0.4), Material::kClutter);
}

}  // namespace

bool place_cabinet(BuildingSketch& sketch,
                   RoomFloor& floor,
                   const Pose2& T_map_wall,
                   double width_m,
                   double depth_m) {
  return place_closed(sketch,
                      floor,
                      rectangle(T_map_wall, 0.0, kBehind_m, width_m, kBehind_m + depth_m),
                      Material::kFurniture);
}

bool place_desk(BuildingSketch& sketch,
                RoomFloor& floor,
                const Pose2& T_map_wall,
                double width_m,
                Random& random) {
  constexpr double kDepth_m = 0.75;
  const double to_wall = kBehind_m + random.uniform(0.0, 0.08);
  if (!floor.take(rectangle(T_map_wall, 0.0, to_wall, width_m, to_wall + kDepth_m))) return false;
  const Pose2 T_map_desk = T_map_wall * Pose2{0.5 * width_m, to_wall + 0.5 * kDepth_m, 0.0};
  add_legs(sketch, T_map_desk, width_m, kDepth_m, 0.05, Material::kFurniture);
  if (random.chance(0.75)) {
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    const Pose2 T_desk_drawers{side * (0.5 * width_m - 0.3), random.uniform(-0.05, 0.05), 0.0};
    add_outline(sketch, box(T_map_desk * T_desk_drawers, 0.42, 0.6), Material::kFurniture);
  }
  if (random.chance(0.3))  // A modesty panel or a cable duct at the back.
    add_outline(sketch,
                box(T_map_desk * Pose2{0.0, 0.05 - 0.5 * kDepth_m, 0.0}, width_m - 0.12, 0.03),
                Material::kFurniture);
  if (random.chance(0.8)) {
    const double along = random.uniform(-0.25, 0.25) * width_m;
    const double turn = random.uniform(-kPi, kPi);
    place_chair(sketch, floor, T_map_desk * Pose2{along, 0.5 * kDepth_m + 0.36, turn}, random);
  }
  return true;
}

bool place_table(BuildingSketch& sketch,
                 RoomFloor& floor,
                 const Pose2& T_map_center,
                 double length_m,
                 double width_m,
                 Random& random) {
  if (!floor.take(box(T_map_center, length_m, width_m))) return false;
  add_legs(sketch, T_map_center, length_m, width_m, 0.06, Material::kFurniture);
  for (const double side : {-1.0, 1.0}) {
    double x = -0.5 * length_m + random.uniform(0.2, 0.5);
    for (; x < 0.5 * length_m - 0.2; x += random.uniform(0.6, 1.0)) {
      const double y = side * (0.5 * width_m + random.uniform(0.27, 0.6));
      const double turn = random.uniform(-0.6, 0.6) - side * 0.5 * kPi;
      if (random.chance(0.8)) place_chair(sketch, floor, T_map_center * Pose2{x, y, turn}, random);
    }
  }
  return true;
}

bool place_chair(BuildingSketch& sketch,
                 RoomFloor& floor,
                 const Pose2& T_map_center,
                 Random& random) {
  if (!floor.take(box(T_map_center, 0.5, 0.48))) return false;
  if (random.chance(0.4))
    add_star_chair(sketch, T_map_center, random);
  else
    add_legs(sketch, T_map_center, 0.46, 0.44, 0.03, Material::kClutter);
  return true;
}

bool place_box(BuildingSketch& sketch,
               RoomFloor& floor,
               const Pose2& T_map_center,
               double length_m,
               double width_m) {
  return place_closed(sketch, floor, box(T_map_center, length_m, width_m), Material::kClutter);
}

bool place_plant(BuildingSketch& sketch,
                 RoomFloor& floor,
                 const Pose2& T_map_center,
                 double radius_m,
                 Random& random) {
  if (!floor.take(box(T_map_center, 2.0 * radius_m, 2.0 * radius_m))) return false;
  ConvexPolygon outline;
  const int num_corners = random.integer(5, 9);
  for (int i = 0; i < num_corners; ++i) {
    const double angle = kTwoPi * (i + random.uniform(-0.3, 0.3)) / num_corners;
    const double radius = radius_m * random.uniform(0.6, 1.0);
    outline.push_back(T_map_center *
                      Eigen::Vector2d(radius * std::cos(angle), radius * std::sin(angle)));
  }
  add_outline(sketch, outline, Material::kClutter);
  return true;
}

bool place_pillar(BuildingSketch& sketch,
                  RoomFloor& floor,
                  const Pose2& T_map_center,
                  double size_m,
                  bool is_round) {
  const ConvexPolygon outline = is_round ? ellipse(T_map_center, 0.5 * size_m, 0.5 * size_m, 16)
                                         : box(T_map_center, size_m, size_m);
  return place_closed(sketch, floor, outline, Material::kPillar);
}

bool place_radiator(BuildingSketch& sketch,
                    RoomFloor& floor,
                    const Pose2& T_map_wall,
                    double width_m) {
  return place_closed(
      sketch, floor, rectangle(T_map_wall, 0.0, 0.03, width_m, 0.14), Material::kWall);
}

}  // namespace setsquare
