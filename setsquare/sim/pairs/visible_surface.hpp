// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/sim/sensing/ray_casting.hpp"
#include "setsquare/sim/sensing/scanner_model.hpp"

namespace setsquare {

/// A return without noise: a place on a wall, in the map frame.
struct SurfaceReturn {
  Eigen::Vector2d p_m;
  Eigen::Vector2d normal;  ///< Of the wall; a unit vector, either way.
  double length_m = 0.0;   ///< Of the wall that this beam stands for, at most 0.25 m.
};

/// A straight part of a wall, in the map frame, in m.
struct SurfacePiece {
  Eigen::Vector2d start_m;
  Eigen::Vector2d end_m;
};

/// What a scanner that stands still sees of a floor plan: no noise, no people, no drop-outs; glass
/// is seen through.
struct VisibleSurface {
  std::vector<SurfaceReturn> returns;  ///< In the order of the beams.
  /// The seen parts of the walls: from a beam's hit to the next one's where both lie on one segment
  /// or on two that touch between the beams (then by their corner). A hit without such neighbours
  /// is a piece of no length.
  std::vector<SurfacePiece> pieces;
};

/// Casts the beams of the scanner at a pose of the sensor.
[[nodiscard]] VisibleSurface visible_surface(const RayCaster& caster,
                                             const ScannerModel& scanner,
                                             const Pose2& T_map_sensor);

}  // namespace setsquare
