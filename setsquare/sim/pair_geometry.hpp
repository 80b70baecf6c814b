// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/core/pose2.hpp"
#include "setsquare/sim/ray_casting.hpp"
#include "setsquare/sim/scanner_model.hpp"

namespace setsquare {

/// What the floor plan alone says of a pair of scans: never a matcher, never noise, never people.
struct PairGeometry {
  /// Share of the current scan's returns that, at the true pose, lie within 0.2 m of a surface that
  /// the reference saw.
  double overlap = 0.0;
  /// Standard deviation of the translation along the worst direction, in m, and of the rotation, in
  /// rad, that the surfaces seen by both allow with independent beams: large where nothing in
  /// common stands across that direction.
  double worst_translation_m = 0.0;
  double rotation_rad = 0.0;
  double worst_direction_rad = 0.0;  ///< In the map frame, modulo pi.
};

[[nodiscard]] PairGeometry pair_geometry(const RayCaster& caster,
                                         const ScannerModel& scanner,
                                         const Pose2& T_map_reference,
                                         const Pose2& T_map_current);

}  // namespace setsquare
