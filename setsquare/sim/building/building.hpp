// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "setsquare/sim/floor_plan.hpp"
#include "setsquare/sim/sensing/person.hpp"

namespace setsquare {

/// Kinds of buildings that the generator makes.
enum class BuildingClass {
  kOffice,    ///< Corridors with rooms on both sides.
  kHall,      ///< Large halls with pillars, shelves, tables.
  kWings,     ///< Several wings that meet at odd angles.
  kCorridor,  ///< Long corridors with little in them.
  kRound,     ///< Round and irregular rooms.
};

inline constexpr std::array kAllBuildingClasses = {BuildingClass::kOffice,
                                                   BuildingClass::kHall,
                                                   BuildingClass::kWings,
                                                   BuildingClass::kCorridor,
                                                   BuildingClass::kRound};

/// "office", "hall", "wings", "corridor", "round".
[[nodiscard]] std::string_view to_string(BuildingClass building_class);

/// A building with the people in it and a way through it.
struct Building {
  FloorPlan plan;
  std::vector<Person> people;
  std::vector<Eigen::Vector2d> route_m;  ///< A drivable way: 0.35 m clear of everything fixed.
};

/// The same building for the same class and seed, on every machine.
[[nodiscard]] Building make_building(BuildingClass building_class, std::uint64_t seed);

/// A hallway like that of the paper's Figure 4.
[[nodiscard]] Building make_paper_hallway(std::uint64_t seed);

/// A place of the large building's track where a circuit of the paper begins and ends.
struct Circuit {
  double start_s_m = 0.0;  ///< Distances along the route.
  double end_s_m = 0.0;
  std::string_view order;  ///< "DCABD" or "GDCABDCBFG".
};

/// A building of 136 x 236 m with a route of 1124 m and the two circuits of section 5.2.
struct PaperBuilding {
  Building building;
  std::array<Circuit, 2> circuits;
};
[[nodiscard]] PaperBuilding make_paper_building(std::uint64_t seed);

/// The building that a name stands for: a class's ("office"), "paper" or "hallway". Throws
/// ParameterError.
[[nodiscard]] Building make_building(std::string_view name, std::uint64_t seed);

}  // namespace setsquare
