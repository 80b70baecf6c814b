// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "setsquare/surfaces/surface_samples.hpp"
#include "setsquare/tracking/scan_tracker_params.hpp"
#include "setsquare/tracking/submap_alignment.hpp"

namespace setsquare {

/// The turn that a scan's walls determine least, and how far they do. In a round hall all walls
/// face its middle: a turn about that leaves every scan as it is.
struct OpenTurn {
  /// The sensor's motion for a turn by 1 rad that leaves the scan where the walls have it.
  Eigen::Vector2d motion_m = Eigen::Vector2d::Zero();
  double information_m2 = 0.0;  ///< Of the turn, the translation left free (points x m^2).
  /// How far the walls bind it: 0 by the noise of their normals alone, 1 clearly.
  double bound_share = 1.0;
};

/// Of normal equations in (x, y, theta) (SubmapAlignment). The translation must be determined.
[[nodiscard]] OpenTurn least_bound_turn(const Eigen::Matrix3d& hessian);

/// The same with the share, of a scan that is where it fits: `alignment` there, and what its points
/// met. Normals that are off by sigma bind a turn by sigma^2 r^2 per point that faces its centre
/// from the distance r, whatever the walls: that is the floor it is compared with. Before the scan
/// fits, the points that show its turn are left out of the alignment, and every turn seems open.
[[nodiscard]] OpenTurn open_turn(const SubmapAlignment& alignment,
                                 const SurfaceSamples& points,
                                 const PointMarks& marks,
                                 double heading_rad,
                                 const OpenTurnParams& params);

}  // namespace setsquare
