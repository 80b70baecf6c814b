// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "setsquare/sim/building.hpp"
#include "setsquare/sim/building_shapes.hpp"
#include "setsquare/sim/floor_plan.hpp"

namespace setsquare {

/// A convex piece of free floor: a room, a corridor, the opening of a door, a niche.
struct Space {
  ConvexPolygon outline;
  /// What stands at each side where no other space goes on; empty: walls all around.
  std::vector<Material> sides;
};

/// An opening that one can drive through. The frame's origin is the middle of the opening on the
/// face of the wall, its x axis points into the wall.
struct Doorway {
  Pose2 T_map_wall;
  double width_m = 0.0;
  double thickness_m = 0.0;  ///< Of the wall.
  bool has_leaf = true;
};

/// A building while it is designed: first the spaces, then the route, then what stands in them.
struct BuildingSketch {
  std::vector<Space> spaces;
  std::vector<Doorway> doorways;
  std::vector<ConvexPolygon> kept_free;   ///< Floor before doors, where nothing is put.
  std::vector<ConvexPolygon> footprints;  ///< Floor that something stands on.
  std::vector<PlanSegment> fittings;      ///< What is seen of all that, at scanner height.
  std::vector<Person> people;
  std::vector<Eigen::Vector2d> route_m;
};

/// Where the spaces end: the boundary of their union. Walls have two faces because the spaces on
/// their two sides do not touch.
[[nodiscard]] std::vector<PlanSegment> wall_segments(const std::vector<Space>& spaces);

/// Whether a new space would be `gap_m` away from all others.
[[nodiscard]] bool is_unbuilt(const BuildingSketch& sketch,
                              const ConvexPolygon& outline,
                              double gap_m);

/// Adds a closed polygon to what is seen, without taking floor.
void add_outline(BuildingSketch& sketch, const ConvexPolygon& outline, Material material);

/// The finished building, turned about the origin.
[[nodiscard]] Building finish(const BuildingSketch& sketch, double rotation_rad);

}  // namespace setsquare
