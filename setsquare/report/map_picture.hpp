// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "setsquare/core/trajectory.hpp"
#include "setsquare/drawing/image.hpp"
#include "setsquare/grid/occupancy_grid.hpp"

namespace setsquare {

/// How well a pose of the trajectory is known; the picture gives each its own colour.
enum class TrackCondition {
  kTracked,
  kDegenerate,  ///< The scans did not determine the motion along one direction.
  kLost,        ///< No match: the pose is carried on by the odometry or the last motion.
};

struct MapPictureParams {
  int max_side_px = 4000;  ///< The longer side of the map, at most; cells are joined until then.
  int min_side_px = 900;   ///< Below it cells are drawn larger, by a whole factor up to 4.
  double margin_m = 1.0;   ///< Around everything that is known.
  bool has_scale_bar = true;
  bool has_legend = true;

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// A map for people: walls, free space, the robot's path with its start and end, a scale bar. The
/// picture's rows are the grid's rows, so a grid along the walls gives upright walls.
/// `T_map_base`: the robot's poses in the map frame, joined in their order; may be empty.
/// `conditions`: one a pose, or empty where every pose is tracked.
[[nodiscard]] Image map_picture(const OccupancyGrid& grid,
                                const Trajectory& T_map_base,
                                std::span<const TrackCondition> conditions = {},
                                const MapPictureParams& params = {});

}  // namespace setsquare
