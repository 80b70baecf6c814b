// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/match_information.hpp"

#include <cmath>
#include <cstdlib>
#include <Eigen/Eigenvalues>

namespace setsquare {
namespace {

double env(const char* n, double v) { return getenv(n) ? atof(getenv(n)) : v; }

void add_one_way(const SurfaceImage& image_a,
                 const SurfaceSamples& samples_b,
                 const Pose2& T_a_b,
                 const Eigen::Matrix3d& A,
                 double tolerance_m,
                 MatchNormal& normal) {
  static const double kPieceLength_m = env("PIECE", 0.25);
  static const double kUnevenness_m = env("UNEVEN", 0.005);
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
      const double facing =
          !has_normal ? 0.3 : (nx * sector.normal_x + ny * sector.normal_y > 0.7F ? 1.0 : 0.0);
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
  static const double kMode = env("MODE", 0), kInfl = env("INFL", 1), kRel = env("REL", 0.05),
                      kFloor = env("FLOOR", 1e-5);
  // Root of the hessian: rotations in units of the walls' lever arm.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(normal.hessian);
  Eigen::Vector3d root = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  const double smallest = 1e-9;
  Eigen::Vector3d inv;
  for (int i = 0; i < 3; ++i) inv(i) = root(i) > smallest ? 1.0 / root(i) : 0.0;
  const Eigen::Matrix3d half = solver.eigenvectors() * root.asDiagonal();  // H = half half^T
  const Eigen::Matrix3d unhalf = solver.eigenvectors() * inv.asDiagonal();
  Eigen::Matrix3d whitened = unhalf.transpose() * normal.scatter * unhalf;
  const double mean = whitened.trace() / 3.0;
  if (kMode == 1) whitened = mean * Eigen::Matrix3d::Identity();
  if (kMode == 2) whitened += kRel * mean * Eigen::Matrix3d::Identity();
  whitened += kFloor * Eigen::Matrix3d::Identity();
  return half * (kInfl * whitened).inverse() * half.transpose();
}

}  // namespace setsquare
