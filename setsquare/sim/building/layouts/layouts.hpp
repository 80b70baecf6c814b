// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/sim/building/sketch.hpp"
#include "setsquare/sim/random.hpp"

namespace setsquare {

// One function per class of buildings; all of them complete a sketch: spaces, route, furniture,
// people.

[[nodiscard]] BuildingSketch sketch_office(Random& random);
[[nodiscard]] BuildingSketch sketch_hall(Random& random);
[[nodiscard]] BuildingSketch sketch_wings(Random& random);
[[nodiscard]] BuildingSketch sketch_corridor(Random& random);
[[nodiscard]] BuildingSketch sketch_round(Random& random);

}  // namespace setsquare
