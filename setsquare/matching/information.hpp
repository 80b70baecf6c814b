// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace setsquare {

/// The normal equations of a match at its pose, in (x, y, theta) of T_reference_current.
struct MatchNormal {
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();  ///< m of wall x (1, m, m^2)
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();  ///< Of the gradient, in m^4 x (1, m, m^2).
};

/// Inverse covariance of the pose by the sandwich rule H S^-1 H: what the wall determines, at the
/// accuracy that the distances themselves show, piece of wall by piece of wall. Singular where H
/// is.
[[nodiscard]] Eigen::Matrix3d match_information(const MatchNormal& normal);

/// The information that is left when nothing is known of the motion along `direction`, a vector in
/// (x, y, theta): exactly singular along it.
[[nodiscard]] Eigen::Matrix3d without_direction(const Eigen::Matrix3d& information,
                                                const Eigen::Vector3d& direction);

}  // namespace setsquare
