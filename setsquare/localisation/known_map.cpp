// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/known_map.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include "setsquare/map/map.hpp"

namespace setsquare {
namespace {

/// placed_keyframes(), with the memory of their scans.
std::vector<MapViews::SharedScan> shared_keyframes(const Map& map) {
  const std::vector<PlacedScan> keyframes = placed_keyframes(map);
  std::vector<MapViews::SharedScan> shared;
  for (const KeptScan& kept : map.kept_scans) {
    if (shared.size() == keyframes.size()) break;
    const PlacedScan& next = keyframes[shared.size()];  // In the order of the kept scans.
    if (next.scan == kept.scan.get()) shared.push_back({kept.scan, next.T_map_sensor});
  }
  return shared;
}

double free_area_m2(const OccupancyGrid& grid) {
  const auto num_free =
      std::ranges::count_if(grid.values(), [](float value) { return value < 0.0F; });
  return grid.resolution_m() * grid.resolution_m() * static_cast<double>(num_free);
}

}  // namespace

KnownMap::KnownMap(const OccupancyGrid& grid)
    : T_map_grid_(grid.T_map_grid()),
      walls_(grid),
      correlation_(walls_),
      free_m2_(free_area_m2(grid)),
      is_empty_(std::ranges::none_of(grid.values(), [](float value) { return value > 0.0F; }) ||
                std::ranges::none_of(grid.values(), [](float value) { return value < 0.0F; })) {}

KnownMap::KnownMap(const OccupancyGrid& grid, std::span<const PlacedScan> scans) : KnownMap(grid) {
  std::vector<MapViews::SharedScan> copied;
  for (const PlacedScan& placed : scans) {
    copied.push_back({std::make_shared<const Scan>(*placed.scan), placed.T_map_sensor});
  }
  views_ = MapViews(copied, T_map_grid_);
}

KnownMap::KnownMap(const Map& map, int num_threads)
    : KnownMap(occupancy_grid(map, num_threads), map) {}

KnownMap::KnownMap(const OccupancyGrid& grid, const Map& map) : KnownMap(grid) {
  views_ = MapViews(shared_keyframes(map), T_map_grid_);
}

}  // namespace setsquare
