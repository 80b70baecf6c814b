// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "setsquare/sim/building/building.hpp"

namespace setsquare {

/// How large an office building is, and how far the robot drives in it.
struct BlockBuildingSize {
  std::size_t num_columns = 2;  ///< Of blocks, each about 13 m square.
  std::size_t num_rows = 2;
  double route_m = 500.0;  ///< At least.
};

/// Offices between corridors that cross, with furniture and people. The robot drives from crossing
/// to crossing, taking the corridors that it has driven least, with visits to rooms on the way: it
/// comes back to every place about twice.
[[nodiscard]] Building make_block_building(const BlockBuildingSize& size, std::uint64_t seed);

}  // namespace setsquare
