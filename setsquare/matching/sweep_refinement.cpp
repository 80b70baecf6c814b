// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/sweep_refinement.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace setsquare {
namespace {

constexpr int kNumSteps = 3;
/// Standard deviation of a turn, before the scans are seen.
constexpr double kTurnSigma = 0.002;
/// Variance of a distance times the length of wall over which it stays: what the prior is worth
/// against a metre of wall.
constexpr double kWallVariance_m3 = 2.5e-5;
constexpr double kTurnWeight = kWallVariance_m3 / (kTurnSigma * kTurnSigma);
/// Holds the pose along a direction that no wall determines, as in `refine`.
constexpr double kDamping = 0.01;

/// The pose's equations once the turns have been solved for: Schur complement and its scatter.
MatchNormal with_turns_free(const SweepNormal& normal) {
  const Eigen::Matrix<double, 3, 2> coupling = normal.hessian.topRightCorner<3, 2>();
  const Eigen::Matrix2d turns =
      normal.hessian.bottomRightCorner<2, 2>() + kTurnWeight * Eigen::Matrix2d::Identity();
  Eigen::Matrix<double, 3, 5> reduce;
  reduce.leftCols<3>().setIdentity();
  reduce.rightCols<2>() = -coupling * turns.inverse();
  Matrix5 scatter = normal.scatter;
  scatter.bottomRightCorner<2, 2>() += kTurnWeight * kWallVariance_m3 * Eigen::Matrix2d::Identity();
  return {.hessian =
              normal.hessian.topLeftCorner<3, 3>() + reduce.rightCols<2>() * coupling.transpose(),
          .scatter = reduce * scatter * reduce.transpose()};
}

}  // namespace

SweepRefinement refine_with_turns(const SweptScan& reference,
                                  const SweptScan& current,
                                  const Pose2& T_reference_current,
                                  double tolerance_m) {
  Pose2 T = T_reference_current;
  SweepTurns turns;
  for (int step = 0; step < kNumSteps; ++step) {
    SweepNormal normal = sweep_normal(reference, current, T, turns, tolerance_m);
    normal.hessian.diagonal().head<3>().array() += kDamping;
    normal.hessian.diagonal().tail<2>().array() += kTurnWeight;
    normal.gradient(3) += kTurnWeight * turns.reference;
    normal.gradient(4) += kTurnWeight * turns.current;
    const Vector5 d = -normal.hessian.ldlt().solve(normal.gradient);
    T = {T.x_m + d(0), T.y_m + d(1), wrap_to_pi(T.theta_rad + d(2))};
    turns = {turns.reference + d(3), turns.current + d(4)};
  }
  const SweepNormal normal = sweep_normal(reference, current, T, turns, tolerance_m);
  return {T, turns, normal.hessian.topLeftCorner<3, 3>(), with_turns_free(normal)};
}

}  // namespace setsquare
