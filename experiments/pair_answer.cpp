// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/pair_answer.hpp"

#include <Eigen/Eigenvalues>

namespace setsquare::experiments {
namespace {

/// Whether the information binds all three of x, y and theta (m and rad taken as equal units).
bool has_full_rank(const Eigen::Matrix3d& information) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(information, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()(0) > 1e-9 * solver.eigenvalues()(2);
}

}  // namespace

Eigen::Vector3d pose_error(const Pose2& answered, const Pose2& truth) {
  return {answered.x_m - truth.x_m,
          answered.y_m - truth.y_m,
          wrap_to_pi(answered.theta_rad - truth.theta_rad)};
}

PairAnswer judge(const MatchResult& result, const Pose2& T_reference_current) {
  PairAnswer answer;
  answer.status = result.status;
  if (!result.T_reference_current) return answer;
  answer.error = pose_error(*result.T_reference_current, T_reference_current);
  if (answer.is_matched() && has_full_rank(result.information)) {
    answer.nees = answer.error.dot(result.information * answer.error);
  }
  return answer;
}

}  // namespace setsquare::experiments
