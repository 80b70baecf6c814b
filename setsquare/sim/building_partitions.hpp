// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/sim/building_floor.hpp"
#include "setsquare/sim/random.hpp"

namespace setsquare {

/// Short walls that stand out from the sides of a room and make bays of it, clear of the route.
/// `num_tries`: how many are tried; those that find no free floor are left out.
void add_partitions(
    BuildingSketch& sketch, RoomFloor& floor, int num_tries, double longest_m, Random& random);

}  // namespace setsquare
