// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/sim/building/sketch.hpp"
#include "setsquare/sim/random.hpp"

namespace setsquare {

// Openings and recesses in walls. A place at a wall is a frame with its origin on the face of the
// wall, its x axis pointing into the wall, its y axis along it.

/// An opening through the wall into the space behind it, with its jambs; floor is kept free on both
/// sides.
void add_doorway(BuildingSketch& sketch, const Doorway& doorway);

/// A closed door, its leaf `recess_m` behind the face of the wall.
void add_closed_door(BuildingSketch& sketch,
                     const Pose2& T_map_wall,
                     double width_m,
                     double recess_m);

/// A window down to the floor, or a glass wall: it ends the space `recess_m` behind the face.
void add_window(BuildingSketch& sketch, const Pose2& T_map_wall, double width_m, double recess_m);

/// A recess in the wall.
void add_niche(BuildingSketch& sketch, const Pose2& T_map_wall, double width_m, double depth_m);

/// A glass pane between this space and the one behind the wall.
void add_glass_partition(BuildingSketch& sketch,
                         const Pose2& T_map_wall,
                         double width_m,
                         double thickness_m);

/// Hangs open leaves, at odd angles, where the route leaves room for them. Comes after the route.
void hang_leaves(BuildingSketch& sketch, Random& random);

}  // namespace setsquare
