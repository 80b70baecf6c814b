// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "setsquare/core/pose2.hpp"
#include "setsquare/matching/information.hpp"
#include "setsquare/matching/match_params.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {
/// How the robot turned while the sensor swept, in rad of heading per rad of bearing: unknown, and
/// seen only where two scans are laid on each other. Half a radian per second under a sensor
/// that sweeps 270 deg in 19 ms makes 0.002, under one that takes 0.1 s per turn 0.008.
struct SweepTurns {
  double reference = 0.0;
  double current = 0.0;
};

using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;

/// The normal equations of point-to-line distances in (x, y, theta) of T_reference_current and the
/// two turns, weighted as in `Alignment`, and how far the distances pull them.
struct SweepNormal {
  Matrix5 hessian = Matrix5::Zero();
  Vector5 gradient = Vector5::Zero();
  /// Scatter of the gradient, summed over pieces of wall: within a piece distances are
  /// correlated (bumps, bias of a material), between pieces they are not.
  Matrix5 scatter = Matrix5::Zero();
};

/// Compares both ways, every sample taken back to where it was at the sweep's middle.
[[nodiscard]] SweepNormal sweep_normal(const SweptScan& reference,
                                       const SweptScan& current,
                                       const Pose2& T_reference_current,
                                       const SweepTurns& turns,
                                       double tolerance_m,
                                       const SweepParams& params = {});

/// A pose refined together with how the robot turned during either sweep.
struct SweepRefinement {
  Pose2 T_reference_current;  ///< At the middles of the sweeps.
  SweepTurns turns;
  Eigen::Matrix3d pose_hessian;  ///< Of the pose, the turns being known: metres of wall.
  MatchNormal normal;            ///< Of the pose, the turns being free.
};

/// A few Gauss-Newton steps, point to line, in pose and turns. The turns are held near zero as a
/// robot's are; where the walls leave a direction free the pose
/// stays put along it.
[[nodiscard]] SweepRefinement refine_with_turns(const SweptScan& reference,
                                                const SweptScan& current,
                                                const Pose2& T_reference_current,
                                                double tolerance_m,
                                                const SweepParams& params = {});

}  // namespace setsquare
