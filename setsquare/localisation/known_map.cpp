// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/known_map.hpp"

#include <algorithm>

namespace setsquare {

KnownMap::KnownMap(const OccupancyGrid& grid)
    : T_map_grid_(grid.T_map_grid()),
      walls_(grid),
      correlation_(walls_),
      is_empty_(std::ranges::none_of(grid.values(), [](float value) { return value > 0.0F; }) ||
                std::ranges::none_of(grid.values(), [](float value) { return value < 0.0F; })) {}

}  // namespace setsquare
