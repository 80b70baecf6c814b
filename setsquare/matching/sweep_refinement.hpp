// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/matching/match_information.hpp"
#include "setsquare/matching/sweep_normal.hpp"

namespace setsquare {

/// A pose refined together with how the robot turned during either sweep.
struct SweepRefinement {
  Pose2 T_reference_current;  ///< At the middles of the sweeps.
  SweepTurns turns;
  Eigen::Matrix3d pose_hessian;  ///< Of the pose, the turns being known: metres of wall.
  MatchNormal normal;            ///< Of the pose, the turns being free.
};

/// A few Gauss-Newton steps, point to line, in pose and turns. The turns are held near zero as a
/// robot's are (a standard deviation of 0.002); where the walls leave a direction free the pose
/// stays put along it.
[[nodiscard]] SweepRefinement refine_with_turns(const SweptScan& reference,
                                                const SweptScan& current,
                                                const Pose2& T_reference_current,
                                                double tolerance_m);

}  // namespace setsquare
