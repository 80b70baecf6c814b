// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from scan_tracker, its only caller: a search of its own.
#pragma once

#include <span>

#include "setsquare/tracking/deskew.hpp"
#include "setsquare/tracking/keyframe.hpp"
#include "setsquare/tracking/scan_tracker_params.hpp"

namespace setsquare {

/// A scan that came while the robot began or ended a turn.
struct UnexpectedScan {
  const Scan& scan;
  Pose2 T_odom_last;       ///< Where the sensor was at the last scan.
  double elapsed_s = 0.0;  ///< Since then.
  double sweep_s = 0.0;
};

/// A turn that explains a scan.
struct SuddenTurn {
  SweepMotion motion;
  Pose2 T_odom_sensor;
};

/// For the kind of scan that a robot takes which begins to turn, at once and fast: it is skewed by
/// a turn that nobody expected, so that it fits nowhere as it is, however it is laid. Every turn
/// during the sweep and every turn since the last scan is tried, on the spot, as far as robots
/// turn; the best by closeness to the submap (closeness_to_submap) is to be refined.
[[nodiscard]] SuddenTurn find_sudden_turn(const UnexpectedScan& unexpected,
                                          std::span<const PlacedImage> submap,
                                          const SurfaceParams& surfaces,
                                          const SuddenTurnParams& params);

}  // namespace setsquare
