// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from scan_tracker, its only caller: how a robot turned during a sweep is a question of its
// own.
#pragma once

#include <span>

#include "setsquare/surfaces/surface_points.hpp"
#include "setsquare/tracking/deskew.hpp"
#include "setsquare/tracking/submap_alignment.hpp"

namespace setsquare {

/// A deskewed scan where it was placed.
struct PlacedSweep {
  const SurfacePoints& points;   ///< Of the deskewed scan.
  std::span<const float> share;  ///< Of its beams (DeskewedScan).
  Pose2 T_odom_sensor;           ///< In the middle of the sweep.
  SweepMotion motion;            ///< By which it was deskewed.
};

/// How the robot turned during either half of a sweep, as far as the walls of the submap show: one
/// Gauss-Newton step, point to line, in the pose and the two turns. A turn that the walls do not
/// show stays near `expected`, whose turns are uncertain by `sigma_rad` each. Returns the sweep's
/// motion with the turns corrected.
///
/// Where a robot begins or ends a turn within a sweep no motion between scans tells how it turned
/// meanwhile; the walls seen before tell.
[[nodiscard]] SweepMotion refined_turns(const PlacedSweep& sweep,
                                        const SweepMotion& expected,
                                        double sigma_rad,
                                        std::span<const PlacedImage> submap,
                                        const AlignmentScale& scale,
                                        PointMarks& marks);

}  // namespace setsquare
