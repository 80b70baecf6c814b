// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "setsquare/graph/robust_pose_graph.hpp"
#include "setsquare/headings/fusion.hpp"
#include "setsquare/headings/square_direction.hpp"
#include "setsquare/mapping/loops/loop_closer.hpp"
#include "setsquare/mapping/pieces/piece_joining.hpp"
#include "setsquare/mapping/registration.hpp"
#include "setsquare/tracking/motion_uncertainty.hpp"
#include "setsquare/tracking/scan_tracker_params.hpp"

namespace setsquare {

/// Parameters of the mapper; every default works.
struct MapperParams {
  ScanTrackerParams tracker;
  SquareDirectionParams direction;
  MotionUncertaintyParams motion;
  HeadingFusionParams heading;
  LoopCloserParams closing;
  PieceJoiningParams joining;
  RobustPoseGraphParams robust;
  RegistrationParams registration;
  /// A direction's confidence grows with its margin over the next one: none at 1, full here.
  double confident_margin = 3.0;
  /// Loops are looked for each time the track has grown by this share, and by so many keyframes.
  double closing_growth = 0.1;
  std::size_t min_closing_growth = 64;
  std::size_t num_threads = 1;  ///< Any number gives the same map.

  /// Throws ParameterError that names the field.
  void validate() const;
};

}  // namespace setsquare
