// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/known_map.hpp"

#include <algorithm>

#include "setsquare/map/map.hpp"

namespace setsquare {

KnownMap::KnownMap(const OccupancyGrid& grid)
    : T_map_grid_(grid.T_map_grid()),
      walls_(grid),
      correlation_(walls_),
      is_empty_(std::ranges::none_of(grid.values(), [](float value) { return value > 0.0F; }) ||
                std::ranges::none_of(grid.values(), [](float value) { return value < 0.0F; })) {}

KnownMap::KnownMap(const OccupancyGrid& grid, std::span<const PlacedScan> scans, int num_threads)
    : KnownMap(grid) {
  views_ = map_views(scans, T_map_grid_, static_cast<std::size_t>(std::max(1, num_threads)));
}

KnownMap::KnownMap(const Map& map, int num_threads)
    : KnownMap(occupancy_grid(map, num_threads), placed_keyframes(map), num_threads) {}

}  // namespace setsquare
