// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/core/pose2.hpp"
#include "setsquare/sim/pairs/visible_surface.hpp"
#include "setsquare/sim/sensing/ray_casting.hpp"
#include "setsquare/sim/sensing/scanner_model.hpp"

namespace setsquare {

/// Geometry of a pair of scans by the floor plan alone, without matcher, noise or people.
struct PairGeometry {
  /// Share of the current scan's returns that, at the true pose, lie within 0.2 m of a surface that
  /// the reference saw.
  double overlap = 0.0;
  /// Length of the surfaces seen by both, weighted by how squarely they stand across the worst
  /// direction, the rotation being free: 0 along a bare corridor.
  double wall_across_m = 0.0;
  /// The same for the rotation, the translation being free: length times squared lever arm. 0 in
  /// the middle of a bare round hall.
  double wall_turning_m3 = 0.0;
  double worst_direction_rad = 0.0;  ///< In the map frame, modulo pi.

  /// Whether the surfaces seen by both determine the relative pose: at least 0.3 m of wall across
  /// every direction and 0.3 m^3 against rotation.
  [[nodiscard]] bool is_determined() const {
    return wall_across_m >= 0.3 && wall_turning_m3 >= 0.3;
  }
};

/// Of what two scans see: computed once per scan, compared once per pair. Each return that both
/// have in common weighs the length of wall that it stands for; normals are those of WallNormals,
/// levers about the centroid of the common returns.
[[nodiscard]] PairGeometry pair_geometry(const VisibleSurface& reference,
                                         const VisibleSurface& current);

/// The same from the poses of the sensor.
[[nodiscard]] PairGeometry pair_geometry(const RayCaster& caster,
                                         const ScannerModel& scanner,
                                         const Pose2& T_map_reference,
                                         const Pose2& T_map_current);

}  // namespace setsquare
