// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "setsquare/sim/building/building.hpp"

namespace setsquare::experiments {

/// Places in which a scan does not determine where it was taken.
enum class SmallWorld {
  kBareCorridor,   ///< Two parallel walls, ends out of reach.
  kSymmetricRoom,  ///< A closed rectangle without anything in it.
  kRoundHall,      ///< A closed circle.
  kOpenField,      ///< None to two posts on a plain.
  kGlassWalls,     ///< A room of glass with a few mullions.
  kNiches,         ///< A corridor with a niche every 2 m on both sides, ends out of reach.
};

inline constexpr std::array kAllSmallWorlds = {SmallWorld::kBareCorridor,
                                               SmallWorld::kSymmetricRoom,
                                               SmallWorld::kRoundHall,
                                               SmallWorld::kOpenField,
                                               SmallWorld::kGlassWalls,
                                               SmallWorld::kNiches};

/// How the page names a world.
struct SmallWorldWords {
  std::string_view name;
  std::string_view truth;  ///< What can be known there.
};
[[nodiscard]] SmallWorldWords words_of(SmallWorld world);

/// The world at a size and a direction that depend on the seed, and a short way through it.
[[nodiscard]] Building make_small_world(SmallWorld world, std::uint64_t seed);

}  // namespace setsquare::experiments
