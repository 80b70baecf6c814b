// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "setsquare/core/pose2.hpp"
#include "setsquare/localisation/wall_distance.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// How far a ray from a place in the grid's frame goes until it meets a wall, in m: the point of
/// the ray that is nearest to the middle of the wall's cell. Infinite where it meets none within
/// `max_range_m`, NaN where it runs through space that the grid does not know. A place in such
/// space is free about itself, as far as a metre: a robot stands there. `direction`: of the ray, of
/// length 1.
[[nodiscard]] double range_to_wall(const WallDistance& walls,
                                   double x_m,
                                   double y_m,
                                   const Eigen::Vector2d& direction,
                                   double max_range_m);

/// The beams of a scanner, not what they measured.
struct BeamLayout {
  double first_bearing_rad = 0.0;
  double bearing_step_rad = 0.0;
  std::size_t num_beams = 0;
  double max_range_m = 30.0;
};

/// Of a scan, but no denser than every half degree and no farther than 30 m: what a grid resolves.
[[nodiscard]] BeamLayout layout_of(const Scan& scan);

/// The scan that a grid leads to expect of a sensor at a place in the grid's frame.
[[nodiscard]] Scan expected_scan(const WallDistance& walls,
                                 const BeamLayout& beams,
                                 const Pose2& T_grid_sensor);

}  // namespace setsquare
