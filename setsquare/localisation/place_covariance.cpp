// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/place_covariance.hpp"

#include <algorithm>
#include <Eigen/LU>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/symmetric_eigen.hpp"

namespace setsquare {
namespace {

/// Turns are weighed as what they move at this distance, so that directions compare.
constexpr double kLever_m = 5.0;
/// Walls in a map of cells are no better known than this ...
constexpr double kMapSigma_m = 0.025;
/// ... and places are searched about as wide as this.
constexpr double kSearched_m = 0.5;

/// The place's information with its directions' variances mapped by `variance_of`.
template <typename VarianceOf>
Eigen::Matrix3d mapped(const Eigen::Matrix3d& information, const VarianceOf& variance_of) {
  const Eigen::DiagonalMatrix<double, 3> unscale(1.0, 1.0, 1.0 / kLever_m);
  const SymmetricEigen<3> eigen = symmetric_eigen(Eigen::Matrix3d(unscale * information * unscale));
  Eigen::Vector3d variances;
  for (int i = 0; i < 3; ++i) variances(i) = variance_of(std::max(0.0, eigen.values(i)));
  const Eigen::Matrix3d scaled = eigen.vectors * variances.asDiagonal() * eigen.vectors.transpose();
  return unscale * scaled * unscale;
}

double variance_of_information(double information) {
  constexpr double kLeast = 1.0 / (kSearched_m * kSearched_m);
  return 1.0 / std::max(kLeast, information) + kMapSigma_m * kMapSigma_m;
}

}  // namespace

Eigen::Matrix3d covariance_of(const VerifiedPlace& place) {
  return mapped(place.information, variance_of_information);
}

Eigen::Matrix3d information_of(const VerifiedPlace& place) {
  const Eigen::DiagonalMatrix<double, 3> scale(1.0, 1.0, kLever_m * kLever_m);
  // Where nothing is known there is no information at all.
  constexpr double kLeast = 1.0 / (kSearched_m * kSearched_m);
  const Eigen::Matrix3d known = mapped(place.information, [](double information) {
    return information <= kLeast ? 0.0 : 1.0 / variance_of_information(information);
  });
  return scale * known * scale;
}

Eigen::Matrix3d turned_covariance(const Eigen::Matrix3d& covariance, double angle_rad) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = rotation_matrix(angle_rad);
  return turn * covariance * turn.transpose();
}

}  // namespace setsquare
