// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/information.hpp"

#include <Eigen/LU>

#include "setsquare/core/symmetric_eigen.hpp"

namespace setsquare {

Eigen::Matrix3d match_information(const MatchNormal& normal) {
  // H = B B^T by its eigenvectors; in the whitened coordinates the sandwich H S^-1 H is
  // B (B^-1 S B^-T)^-1 B^T, which stays finite where H is singular.
  const SymmetricEigen<3> eigen = symmetric_eigen(normal.hessian);
  const Eigen::Vector3d root = eigen.values.cwiseMax(0.0).cwiseSqrt();
  constexpr double kTiny = 1e-9;  // Of rounding; decides nothing.
  // Variance times length of a piece of wall: no scanner on a real wall shows less. It keeps the
  // information finite on simulated walls without noise; measured scatter is far above it.
  constexpr double kLeastScatter_m3 = 1e-5;
  const Eigen::Vector3d inverse_root =
      (root.array() > kTiny).select(root.cwiseMax(kTiny).cwiseInverse(), 0.0);
  const Eigen::Matrix3d B = eigen.vectors * root.asDiagonal();
  const Eigen::Matrix3d B_inverse_transpose = eigen.vectors * inverse_root.asDiagonal();
  const Eigen::Matrix3d whitened =
      B_inverse_transpose.transpose() * normal.scatter * B_inverse_transpose +
      kLeastScatter_m3 * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d information = B * whitened.inverse() * B.transpose();
  return 0.5 * (information + information.transpose());  // To the last bit.
}

Eigen::Matrix3d without_direction(const Eigen::Matrix3d& information,
                                  const Eigen::Vector3d& direction) {
  const Eigen::Vector3d bound = information * direction;
  const double along = direction.dot(bound);
  if (!(along > 0.0)) return information;
  Eigen::Matrix3d left = information - bound * bound.transpose() / along;
  left.diagonal() = left.diagonal().cwiseMax(0.0);  // rounding may leave a zero below itself
  return left;
}

}  // namespace setsquare
