// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The step that every refinement of a pose takes.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// Normal equations of a least-squares problem: hessian * step = -gradient.
template <int kSize>
struct NormalEquations {
  Eigen::Matrix<double, kSize, kSize> hessian = Eigen::Matrix<double, kSize, kSize>::Zero();
  Eigen::Matrix<double, kSize, 1> gradient = Eigen::Matrix<double, kSize, 1>::Zero();
};

/// The Gauss-Newton step, damped: where the data determine nothing the step is short, not wild.
/// `damping`: added to the hessian's diagonal, in its units. `prior`: what is known in addition to
/// the data. For kSize 3 and 5.
template <int kSize>
[[nodiscard]] Eigen::Matrix<double, kSize, 1> damped_step(
    const NormalEquations<kSize>& data,
    const Eigen::Matrix<double, kSize, 1>& damping,
    const NormalEquations<kSize>& prior = {});

/// The same with one damping for all: for a pose, in points or metres of wall x (1, m^2).
[[nodiscard]] inline Eigen::Vector3d damped_step(const NormalEquations<3>& data,
                                                 double damping,
                                                 const NormalEquations<3>& prior = {}) {
  return damped_step<3>(data, Eigen::Vector3d::Constant(damping), prior);
}

/// The same in a third of the time, without a prior: for the guess-free matcher, which takes
/// hundreds of steps per pair of scans. Differs in the last digits.
[[nodiscard]] inline Eigen::Vector3d quick_damped_step(const NormalEquations<3>& data,
                                                       double damping) {
  const Eigen::Matrix3d damped = data.hessian + damping * Eigen::Matrix3d::Identity();
  return -(damped.inverse() * data.gradient);
}

/// The pose after a step in its (x, y, theta).
[[nodiscard]] inline Pose2 stepped(const Pose2& T, const Eigen::Vector3d& step) {
  return {T.x_m + step.x(), T.y_m + step.y(), wrap_to_pi(T.theta_rad + step.z())};
}

}  // namespace setsquare
