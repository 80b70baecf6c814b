// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/core/pose2.hpp"
#include "setsquare/grid/occupancy_grid.hpp"
#include "setsquare/localisation/map_correlation.hpp"
#include "setsquare/localisation/wall_distance.hpp"

namespace setsquare {

/// A map made ready to find scans in it: once, in some tenths of a second for a building, and never
/// changed.
class KnownMap {
 public:
  /// Of an occupancy grid, of whichever program (read_map_pgm_yaml).
  explicit KnownMap(const OccupancyGrid& grid);

  /// The pose of the grid, in whose frame places are searched.
  [[nodiscard]] const Pose2& T_map_grid() const { return T_map_grid_; }
  /// How far the nearest wall is from each of its cells.
  [[nodiscard]] const WallDistance& walls() const { return walls_; }
  /// With which scans are correlated.
  [[nodiscard]] const MapCorrelation& correlation() const { return correlation_; }
  /// Whether it has walls and free space at all.
  [[nodiscard]] bool is_empty() const { return is_empty_; }

 private:
  Pose2 T_map_grid_;
  WallDistance walls_;
  MapCorrelation correlation_;
  bool is_empty_ = true;
};

}  // namespace setsquare
