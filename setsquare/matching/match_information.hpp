// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "setsquare/matching/alignment.hpp"

namespace setsquare {

/// The normal equations of a match at its pose, and how far the distances pull them.
struct MatchNormal {
  /// In (x, y, theta) of T_reference_current, distances weighted as in `Alignment`.
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
  /// Scatter of the gradient, summed over pieces of wall: within a piece distances are alike
  /// (bumps, bias of a material), between pieces they are not.
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
};

[[nodiscard]] MatchNormal match_normal(const AlignedScan& reference,
                                       const AlignedScan& current,
                                       const Pose2& T_reference_current,
                                       double tolerance_m);

/// Inverse covariance of the pose by the sandwich rule H S^-1 H: what the wall determines, at the
/// accuracy that the distances themselves show, piece of wall by piece of wall. Singular where H
/// is.
[[nodiscard]] Eigen::Matrix3d match_information(const MatchNormal& normal);

}  // namespace setsquare
