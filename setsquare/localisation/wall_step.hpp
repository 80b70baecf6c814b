// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Shared by the refinements onto the walls of a grid and onto those that a map's own scans saw.
#pragma once

#include <algorithm>

#include "setsquare/core/damped_step.hpp"

namespace setsquare {

/// A pose after a step of Gauss and Newton onto walls, not longer than `max_step_m` along an axis.
/// Where the walls leave a direction open it stays put along it.
[[nodiscard]] inline Pose2 stepped_onto_walls(const Pose2& T,
                                              const NormalEquations<3>& equations,
                                              double max_step_m) {
  constexpr double kMaxTurn_rad = 0.1;
  const Eigen::Vector3d damping = 1e-3 + 0.02 * equations.hessian.diagonal().array();
  const Eigen::Vector3d longest(max_step_m, max_step_m, kMaxTurn_rad);
  return stepped(T, damped_step<3>(equations, damping).cwiseMax(-longest).cwiseMin(longest));
}

}  // namespace setsquare
