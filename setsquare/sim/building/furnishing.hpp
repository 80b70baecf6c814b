// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "setsquare/sim/building/rooms.hpp"
#include "setsquare/sim/building/sketch.hpp"

namespace setsquare {

/// Puts furniture and clutter into a room according to its use: along its walls, then on its floor.
/// Comes after the route, which is kept clear.
void furnish(BuildingSketch& sketch, const Room& room);

/// People who stand, and people who walk to and fro on a free line, clear of all that is fixed and
/// of the route.
void add_people(BuildingSketch& sketch,
                const ConvexPolygon& outline,
                int num_people,
                double walking_share,
                Random& random);

}  // namespace setsquare
