// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <vector>

namespace setsquare {

/// The z of the cross product: twice the area that the two span, positive where b is left of a.
[[nodiscard]] inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// What a line of the plan is made of: how it reflects, and whether it belongs to the building.
enum class Material : std::uint8_t {
  kWall,
  kDoor,   ///< A closed door leaf, or an open one standing in the room.
  kGlass,  ///< Windows and glass walls: seen only near normal incidence, else seen through.
  kPillar,
  kFurniture,  ///< Tables, cabinets, shelves: mostly along the walls.
  kClutter,    ///< Chairs, boxes, bags, plants at odd angles.
  kPerson,     ///< A leg of a person who stands or walks.
};

/// Furniture, clutter and people: what is not the building.
[[nodiscard]] constexpr bool is_clutter(Material material) {
  return material == Material::kFurniture || material == Material::kClutter ||
         material == Material::kPerson;
}

/// A straight piece of a wall, in the map frame, in m.
struct PlanSegment {
  Eigen::Vector2d start_m;
  Eigen::Vector2d end_m;
  Material material = Material::kWall;
};

/// What a scanner at one height can meet: segments in no order. Round things are polygons.
struct FloorPlan {
  std::vector<PlanSegment> segments;
};

/// Appends the segments from corner to corner; `closed`: and back to the first.
void add_polyline(FloorPlan& plan,
                  const std::vector<Eigen::Vector2d>& corners_m,
                  Material material,
                  bool closed = true);

}  // namespace setsquare
