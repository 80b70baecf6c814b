// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "setsquare/core/loop_closure.hpp"
#include "setsquare/core/trajectory.hpp"
#include "setsquare/drawing/image.hpp"
#include "setsquare/grid/occupancy_grid.hpp"

namespace setsquare {

/// How well a pose of the trajectory is known; the picture gives each its own colour.
enum class TrackCondition {
  kTracked,
  kDegenerate,  ///< The scans did not determine the motion along one direction.
  kLost,        ///< No match: the pose is carried on by the odometry or the last motion.
  kNotPlaced,   ///< Nobody knows where in the map: not drawn.
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

/// What is drawn upon the map's cells; all of it may be empty.
struct MapPictureLayers {
  std::span<const StampedPose> T_map_base;     ///< The robot's poses, joined in their order.
  std::span<const TrackCondition> conditions;  ///< One per pose; empty where every pose is tracked.
  std::span<const LoopClosure> closures;       ///< Of poses with those stamps.
};

/// A map for people: walls, free space, loop closures, the robot's path with its start and end, a
/// scale bar. The picture's rows are the grid's rows, so a grid along the walls gives upright
/// walls. Accepted closures join their poses, the paler the less they weigh in the final graph;
/// refused ones, and those whose stamps no pose has, are left out. The legend names what is there.
[[nodiscard]] Image layered_map_picture(const OccupancyGrid& grid,
                                        const MapPictureLayers& layers,
                                        const MapPictureParams& params = {});

/// The same without closures.
[[nodiscard]] Image map_picture(const OccupancyGrid& grid,
                                const Trajectory& T_map_base,
                                std::span<const TrackCondition> conditions = {},
                                const MapPictureParams& params = {});

}  // namespace setsquare
