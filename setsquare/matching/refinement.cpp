// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/refinement.hpp"

#include <Eigen/LU>

namespace setsquare {

Pose2 refine(const AlignedScan& reference,
             const AlignedScan& current,
             const Pose2& T_reference_current,
             std::span<const double> tolerances_m) {
  // Holds the pose along a direction that no wall determines (m of wall, m of wall x m^2).
  constexpr double kDamping = 0.01;
  Pose2 T = T_reference_current;
  for (const double tolerance_m : tolerances_m) {
    const Alignment alignment = align(reference, current, T, tolerance_m);
    const Eigen::Matrix3d damped = alignment.hessian + kDamping * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d step = -(damped.inverse() * alignment.gradient);
    T = {T.x_m + step.x(), T.y_m + step.y(), wrap_to_pi(T.theta_rad + step.z())};
  }
  return T;
}

}  // namespace setsquare
