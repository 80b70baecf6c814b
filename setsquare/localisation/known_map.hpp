// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "setsquare/core/pose2.hpp"
#include "setsquare/grid/occupancy_grid.hpp"
#include "setsquare/grid/placed_scan.hpp"
#include "setsquare/localisation/map_correlation.hpp"
#include "setsquare/localisation/map_views.hpp"
#include "setsquare/localisation/wall_distance.hpp"

namespace setsquare {

struct Map;  // setsquare/map/map.hpp

/// A map made ready to find scans in it: once, in some tenths of a second for a building. Any
/// number of threads may use it.
class KnownMap {
 public:
  /// Of an occupancy grid, of whichever program (read_map_pgm_yaml).
  explicit KnownMap(const OccupancyGrid& grid);
  /// The same with scans of which the grid was made: what single walls look like from single places
  /// tells apart what is alike in a grid. They are copied, and looked at when a place is in doubt.
  KnownMap(const OccupancyGrid& grid, std::span<const PlacedScan> scans);
  /// Of a map's grid and of its keyframes' scans, whose memory it shares until it has looked at
  /// them.
  explicit KnownMap(const Map& map, int num_threads = 1);
  /// The same where the map's grid is at hand.
  KnownMap(const OccupancyGrid& grid, const Map& map);

  /// The pose of the grid, in whose frame places are searched.
  [[nodiscard]] const Pose2& T_map_grid() const { return T_map_grid_; }
  /// How far the nearest wall is from each of its cells.
  [[nodiscard]] const WallDistance& walls() const { return walls_; }
  /// With which scans are correlated.
  [[nodiscard]] const MapCorrelation& correlation() const { return correlation_; }
  /// What its scans saw, where it has any; in the grid's frame.
  [[nodiscard]] const MapViews& views() const { return views_; }
  /// How much of it is free, in m2.
  [[nodiscard]] double free_m2() const { return free_m2_; }
  /// Whether it has walls and free space at all.
  [[nodiscard]] bool is_empty() const { return is_empty_; }

 private:
  Pose2 T_map_grid_;
  WallDistance walls_;
  MapCorrelation correlation_;
  MapViews views_;
  double free_m2_ = 0.0;
  bool is_empty_ = true;
};

}  // namespace setsquare
