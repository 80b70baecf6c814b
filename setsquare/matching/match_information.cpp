// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/match_information.hpp"

#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace setsquare {
namespace {

/// Distances of samples nearer than this along the wall share one cause.
constexpr double kPieceLength_m = 0.25;
/// Standard deviation of what a whole piece is off by, though its own samples do not show it.
constexpr double kUnevenness_m = 0.005;
/// Variance times piece length below which nobody believes it, in m^3.
constexpr double kLeastScatter_m3 = 1e-5;
/// A sample without a fitted line counts for less, as in `align`.
constexpr double kClutterWeight = 0.3;
constexpr float kMinNormalCosine = 0.7F;

void add_one_way(const SurfaceImage& image_a,
                 const SurfaceSamples& samples_b,
                 const Pose2& T_a_b,
                 const Eigen::Matrix3d& A,
                 double tolerance_m,
                 MatchNormal& normal) {
  const float c = static_cast<float>(std::cos(T_a_b.theta_rad));
  const float s = static_cast<float>(std::sin(T_a_b.theta_rad));
  const float tx = static_cast<float>(T_a_b.x_m);
  const float ty = static_cast<float>(T_a_b.y_m);
  double piece_m = 0.0;
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
  Eigen::Vector3d weight = Eigen::Vector3d::Zero();
  const auto close_piece = [&] {
    normal.scatter +=
        pull * pull.transpose() + kUnevenness_m * kUnevenness_m * weight * weight.transpose();
    pull.setZero();
    weight.setZero();
    piece_m = 0.0;
  };
  for (std::size_t i = 0; i < samples_b.size(); ++i) {
    const float x = c * samples_b.x_m[i] - s * samples_b.y_m[i] + tx;
    const float y = s * samples_b.x_m[i] + c * samples_b.y_m[i] + ty;
    const float nx = c * samples_b.normal_x[i] - s * samples_b.normal_y[i];
    const float ny = s * samples_b.normal_x[i] + c * samples_b.normal_y[i];
    const SurfaceSector& sector = image_a.at(x, y);
    const double d = SurfaceImage::signed_distance_m(sector, x, y);
    const double u = d / tolerance_m;
    const double nearness = 1.0 - u * u;
    piece_m += samples_b.weight_m[i];
    if (nearness > 0.0) {
      const bool has_normal = nx != 0.0F || ny != 0.0F;
      const bool faces_alike = nx * sector.normal_x + ny * sector.normal_y > kMinNormalCosine;
      const double facing = !has_normal ? kClutterWeight : (faces_alike ? 1.0 : 0.0);
      const double w = samples_b.weight_m[i] * facing * nearness * nearness;
      const Eigen::Vector3d J =
          A * Eigen::Vector3d(
                  sector.normal_x, sector.normal_y, sector.normal_y * x - sector.normal_x * y);
      normal.hessian += w * J * J.transpose();
      pull += w * d * J;
      weight += w * J;
    }
    if (piece_m >= kPieceLength_m) close_piece();
  }
  close_piece();
}

}  // namespace

MatchNormal match_normal(const AlignedScan& reference,
                         const AlignedScan& current,
                         const Pose2& T,
                         double tolerance_m) {
  MatchNormal normal;
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
  A(2, 0) = T.y_m;
  A(2, 1) = -T.x_m;
  add_one_way(reference.image, current.samples, T, A, tolerance_m, normal);
  const double c = std::cos(T.theta_rad);
  const double s = std::sin(T.theta_rad);
  A << -c, s, 0.0,  //
      -s, -c, 0.0,  //
      0.0, 0.0, -1.0;
  add_one_way(current.image, reference.samples, T.inverse(), A, tolerance_m, normal);
  return normal;
}

Eigen::Matrix3d match_information(const MatchNormal& normal) {
  // H = B B^T by its eigenvectors; in the whitened coordinates the sandwich H S^-1 H is
  // B (B^-1 S B^-T)^-1 B^T, which stays finite where H is singular.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(normal.hessian);
  const Eigen::Vector3d root = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  constexpr double kTiny = 1e-9;
  const Eigen::Vector3d inverse_root =
      (root.array() > kTiny).select(root.cwiseMax(kTiny).cwiseInverse(), 0.0);
  const Eigen::Matrix3d B = solver.eigenvectors() * root.asDiagonal();
  const Eigen::Matrix3d B_inverse = solver.eigenvectors() * inverse_root.asDiagonal();
  const Eigen::Matrix3d whitened = B_inverse.transpose() * normal.scatter * B_inverse +
                                   kLeastScatter_m3 * Eigen::Matrix3d::Identity();
  return B * whitened.inverse() * B.transpose();
}

}  // namespace setsquare
