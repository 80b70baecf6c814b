// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/building/building.hpp"

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/sim/building/layouts/layouts.hpp"

namespace setsquare {
namespace {

BuildingSketch sketch_building(BuildingClass building_class, Random& random) {
  switch (building_class) {
    case BuildingClass::kOffice:
      return sketch_office(random);
    case BuildingClass::kHall:
      return sketch_hall(random);
    case BuildingClass::kWings:
      return sketch_wings(random);
    case BuildingClass::kCorridor:
      return sketch_corridor(random);
    case BuildingClass::kRound:
      return sketch_round(random);
  }
  return {};
}

}  // namespace

std::string_view to_string(BuildingClass building_class) {
  switch (building_class) {
    case BuildingClass::kOffice:
      return "office";
    case BuildingClass::kHall:
      return "hall";
    case BuildingClass::kWings:
      return "wings";
    case BuildingClass::kCorridor:
      return "corridor";
    case BuildingClass::kRound:
      return "round";
  }
  return "";
}

Building make_building(BuildingClass building_class, std::uint64_t seed) {
  Random random(sub_seed(seed, static_cast<std::uint64_t>(building_class)));
  const BuildingSketch sketch = sketch_building(building_class, random);
  return finish(sketch, random.uniform(-kPi, kPi));
}

Building make_building(std::string_view name, std::uint64_t seed) {
  if (name == "paper") return make_paper_building(seed).building;
  if (name == "hallway") return make_paper_hallway(seed);
  for (const BuildingClass building_class : kAllBuildingClasses) {
    if (to_string(building_class) == name) return make_building(building_class, seed);
  }
  throw ParameterError("building",
                       "must be office, hall, wings, corridor, round, paper or hallway");
}

}  // namespace setsquare
