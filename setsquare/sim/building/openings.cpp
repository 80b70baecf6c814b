// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/building/openings.hpp"

#include <algorithm>
#include <cstddef>

#include "setsquare/core/angle.hpp"

namespace setsquare {
namespace {

// An opening reaches this far into the spaces that it joins: no side of one lies on a side of
// another.
constexpr double kReach_m = 0.02;

ConvexPolygon recess(const Pose2& T_map_wall, double width_m, double depth_m) {
  return rectangle(T_map_wall, -kReach_m, -0.5 * width_m, depth_m, 0.5 * width_m);
}

void keep_free(BuildingSketch& sketch,
               const Pose2& T_map_wall,
               double width_m,
               double from_x_m,
               double to_x_m) {
  sketch.kept_free.push_back(
      rectangle(T_map_wall, from_x_m, -0.5 * width_m, to_x_m, 0.5 * width_m));
}

bool is_clear_of_route(const BuildingSketch& sketch, const ConvexPolygon& outline, double gap_m) {
  for (std::size_t i = 1; i < sketch.route_m.size(); ++i)
    if (!are_apart(outline, {sketch.route_m[i - 1], sketch.route_m[i]}, gap_m)) return false;
  return true;
}

bool is_in_a_space(const BuildingSketch& sketch, const ConvexPolygon& outline) {
  return std::any_of(sketch.spaces.begin(), sketch.spaces.end(), [&outline](const Space& space) {
    return contains(space.outline, outline);
  });
}

/// The outline of a leaf that hangs at one of the jambs and stands open by an angle.
ConvexPolygon open_leaf(const Doorway& doorway, bool at_left_jamb, double opening_rad) {
  constexpr double kLeafThickness_m = 0.04;
  const double side = at_left_jamb ? 1.0 : -1.0;
  const Pose2 T_wall_hinge{doorway.thickness_m + 0.03,
                           side * (0.5 * doorway.width_m + 0.02),
                           side * (opening_rad - 0.5 * kPi)};
  const Pose2 T_map_hinge = doorway.T_map_wall * T_wall_hinge;
  return rectangle(
      T_map_hinge, 0.0, -0.5 * kLeafThickness_m, doorway.width_m - 0.02, 0.5 * kLeafThickness_m);
}

}  // namespace

void add_doorway(BuildingSketch& sketch, const Doorway& doorway) {
  const double depth = doorway.thickness_m + kReach_m;
  sketch.spaces.push_back({recess(doorway.T_map_wall, doorway.width_m, depth), {}});
  sketch.doorways.push_back(doorway);
  keep_free(sketch, doorway.T_map_wall, doorway.width_m, -0.8, depth + 0.8);
}

void add_closed_door(BuildingSketch& sketch,
                     const Pose2& T_map_wall,
                     double width_m,
                     double recess_m) {
  using enum Material;
  sketch.spaces.push_back({recess(T_map_wall, width_m, recess_m), {kWall, kDoor, kWall, kWall}});
  keep_free(sketch, T_map_wall, width_m, -0.6, 0.0);
}

void add_window(BuildingSketch& sketch, const Pose2& T_map_wall, double width_m, double recess_m) {
  using enum Material;
  sketch.spaces.push_back({recess(T_map_wall, width_m, recess_m), {kWall, kGlass, kWall, kWall}});
}

void add_niche(BuildingSketch& sketch, const Pose2& T_map_wall, double width_m, double depth_m) {
  sketch.spaces.push_back({recess(T_map_wall, width_m, depth_m), {}});
}

void add_glass_partition(BuildingSketch& sketch,
                         const Pose2& T_map_wall,
                         double width_m,
                         double thickness_m) {
  sketch.spaces.push_back({recess(T_map_wall, width_m, thickness_m + kReach_m), {}});
  const double x = 0.5 * thickness_m;
  sketch.fittings.push_back({T_map_wall * Eigen::Vector2d(x, -0.5 * width_m),
                             T_map_wall * Eigen::Vector2d(x, 0.5 * width_m),
                             Material::kGlass});
}

void hang_leaves(BuildingSketch& sketch, Random& random) {
  constexpr double kLeafToRoute_m = 0.37;
  constexpr int kTries = 4;
  for (const Doorway& doorway : sketch.doorways) {
    if (!doorway.has_leaf) continue;
    const bool at_left_jamb = random.chance(0.5);
    for (int i = 0; i < kTries; ++i) {
      const double opening = rad_from_deg(random.uniform(70.0, 165.0));
      const ConvexPolygon leaf = open_leaf(doorway, at_left_jamb, opening);
      if (!is_clear_of_route(sketch, leaf, kLeafToRoute_m) || !is_in_a_space(sketch, leaf))
        continue;
      add_outline(sketch, leaf, Material::kDoor);
      sketch.footprints.push_back(leaf);
      break;
    }
  }
}

}  // namespace setsquare
