// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/sim/building/floor.hpp"
#include "setsquare/sim/random.hpp"

namespace setsquare {

// Single pieces of furniture as a scanner 0.3 m above the floor meets them. A piece that stands at
// a wall has a frame with its origin at the wall, x along the wall, y into the room. Each takes its
// floor and returns whether the floor was free.

/// A cabinet, shelf or counter: closed down to the floor.
bool place_cabinet(BuildingSketch& sketch,
                   RoomFloor& floor,
                   const Pose2& T_map_wall,
                   double width_m,
                   double depth_m);

/// A desk: four thin legs, at most one box of drawers, mostly a chair before it.
bool place_desk(BuildingSketch& sketch,
                RoomFloor& floor,
                const Pose2& T_map_wall,
                double width_m,
                Random& random);

/// A table in the room with chairs about it.
bool place_table(BuildingSketch& sketch,
                 RoomFloor& floor,
                 const Pose2& T_map_center,
                 double length_m,
                 double width_m,
                 Random& random);

/// A chair with four legs, or one with a column and a star of feet.
bool place_chair(BuildingSketch& sketch,
                 RoomFloor& floor,
                 const Pose2& T_map_center,
                 Random& random);

/// A cardboard box, bag or bin.
bool place_box(BuildingSketch& sketch,
               RoomFloor& floor,
               const Pose2& T_map_center,
               double length_m,
               double width_m);

/// A pot with a plant: a polygon of uneven corners.
bool place_plant(BuildingSketch& sketch,
                 RoomFloor& floor,
                 const Pose2& T_map_center,
                 double radius_m,
                 Random& random);

/// Part of the building: a pillar, round or square, or a radiator at a wall.
bool place_pillar(BuildingSketch& sketch,
                  RoomFloor& floor,
                  const Pose2& T_map_center,
                  double size_m,
                  bool is_round);
bool place_radiator(BuildingSketch& sketch,
                    RoomFloor& floor,
                    const Pose2& T_map_wall,
                    double width_m);

}  // namespace setsquare
