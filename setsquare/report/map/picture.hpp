// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "setsquare/core/loop_closure.hpp"
#include "setsquare/core/trajectory.hpp"
#include "setsquare/drawing/image.hpp"
#include "setsquare/grid/occupancy_grid.hpp"
#include "setsquare/map/map.hpp"

namespace setsquare {

struct MapPictureParams {
  int max_side_px = 4000;  ///< The longer side of the map, at most; cells are joined until then.
  int min_side_px = 900;   ///< Below it cells are drawn larger, by a whole factor up to 4.
  double margin_m = 1.0;   ///< Around everything that is known.
  bool has_scale_bar = true;
  bool has_legend = true;

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// What is drawn upon the map's cells; all of it may be empty.
struct MapPictureLayers {
  /// The robot's poses, joined in their order, each in the colour of its status; those that are not
  /// placed are gaps.
  std::span<const MappedScan> scans;
  std::span<const LoopClosure> closures;      ///< Of scans with those stamps.
  std::span<const MapDoubt> doubts = {};      ///< Numbered from 1 in their order.
  std::span<const MapSession> sessions = {};  ///< Their ways are not joined to each other, ...
  std::span<const ForgottenPoses> gaps = {};  ///< ... nor those before and behind scans left out.
};

/// A map for people: walls, free space, loop closures, the robot's path with its start and end, a
/// scale bar. The picture's rows are the grid's rows, so a grid along the walls gives upright
/// walls. Accepted closures join their poses, the paler the less they weigh in the final graph;
/// refused ones, and those whose stamps no pose has, are left out. The legend names what is there.
[[nodiscard]] Image layered_map_picture(const OccupancyGrid& grid,
                                        const MapPictureLayers& layers,
                                        const MapPictureParams& params = {});

/// The same of a path without closures, all of it tracked.
[[nodiscard]] Image map_picture(const OccupancyGrid& grid,
                                const Trajectory& T_map_base,
                                const MapPictureParams& params = {});

}  // namespace setsquare
