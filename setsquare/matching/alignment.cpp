// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/alignment.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace setsquare {
namespace {

/// A sample without a fitted line counts for less: it may be anything.
constexpr float kClutterWeight = 0.3F;
/// Walls that agree face the same way within this angle's cosine.
constexpr float kMinNormalCosine = 0.7F;
/// Offsets beyond it are no surface's.
constexpr float kHalfNoSurface_m = 0.5F * SurfaceImage::kNoSurface_m;

constexpr std::size_t kBlock = 64;

/// A block of samples moved into the image's frame, with the sector that each falls into.
struct MovedBlock {
  std::array<float, kBlock> x_m;
  std::array<float, kBlock> y_m;
  std::array<float, kBlock> normal_x;
  std::array<float, kBlock> normal_y;
  std::array<std::int32_t, kBlock> sector;
};

/// Sums over the samples; the six products and three moments of b = (n_x, n_y, n_y q_x - n_x q_y),
/// the derivative of a distance by a motion of the image's frame.
struct Sums {
  float wall = 0.0F;
  float agreeing = 0.0F;
  float contradicted = 0.0F;
  float hidden = 0.0F;
  float outside = 0.0F;
  float xx = 0.0F, xy = 0.0F, yy = 0.0F, xt = 0.0F, yt = 0.0F, tt = 0.0F;
  float gx = 0.0F, gy = 0.0F, gt = 0.0F;
};

void move_block(const SurfaceImage& image,
                const SurfaceSamples& samples,
                const Pose2& T,
                std::size_t first,
                std::size_t count,
                MovedBlock& moved) {
  const float c = static_cast<float>(std::cos(T.theta_rad));
  const float s = static_cast<float>(std::sin(T.theta_rad));
  const float tx = static_cast<float>(T.x_m);
  const float ty = static_cast<float>(T.y_m);
  const float* x = samples.x_m.data() + first;
  const float* y = samples.y_m.data() + first;
  const float* nx = samples.normal_x.data() + first;
  const float* ny = samples.normal_y.data() + first;
  for (std::size_t i = 0; i < count; ++i) {
    moved.x_m[i] = c * x[i] - s * y[i] + tx;
    moved.y_m[i] = s * x[i] + c * y[i] + ty;
    moved.normal_x[i] = c * nx[i] - s * ny[i];
    moved.normal_y[i] = s * nx[i] + c * ny[i];
    moved.sector[i] = image.sector_index(moved.x_m[i], moved.y_m[i]);
  }
}

void add_sample(const SurfaceSector& sector,
                const MovedBlock& moved,
                std::size_t i,
                float weight,
                float inverse_tolerance,
                Sums& sums) {
  const float x = moved.x_m[i];
  const float y = moved.y_m[i];
  const float distance = SurfaceImage::signed_distance_m(sector, x, y);
  const float u = distance * inverse_tolerance;
  const float nearness = 1.0F - u * u;
  if (nearness > 0.0F) {
    const float cosine = sector.normal_x * moved.normal_x[i] + sector.normal_y * moved.normal_y[i];
    const bool has_normal = moved.normal_x[i] != 0.0F || moved.normal_y[i] != 0.0F;
    const float facing = has_normal ? (cosine > kMinNormalCosine ? 1.0F : 0.0F) : kClutterWeight;
    const float agreeing = weight * facing * nearness;
    sums.agreeing += agreeing;
    const float w = agreeing * nearness;
    const float bt = sector.normal_y * x - sector.normal_x * y;
    const float wx = w * sector.normal_x;
    const float wy = w * sector.normal_y;
    const float wt = w * bt;
    sums.xx += wx * sector.normal_x;
    sums.xy += wx * sector.normal_y;
    sums.yy += wy * sector.normal_y;
    sums.xt += wx * bt;
    sums.yt += wy * bt;
    sums.tt += wt * bt;
    sums.gx += wx * distance;
    sums.gy += wy * distance;
    sums.gt += wt * distance;
  } else if (x * x + y * y < sector.free_square_m2 &&
             (distance > 0.0F || distance < -kHalfNoSurface_m)) {
    sums.contradicted += weight;
  } else if (distance < -kHalfNoSurface_m) {
    sums.outside += weight;
  } else if (distance < 0.0F) {
    sums.hidden += weight;
  }
}

Sums sum_over_samples(const SurfaceImage& image,
                      const SurfaceSamples& samples,
                      const Pose2& T_a_b,
                      double tolerance_m) {
  Sums sums;
  MovedBlock moved;
  const float inverse_tolerance = static_cast<float>(1.0 / tolerance_m);
  for (std::size_t first = 0; first < samples.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, samples.size() - first);
    move_block(image, samples, T_a_b, first, count, moved);
    for (std::size_t i = 0; i < count; ++i) {
      const float weight = samples.weight_m[first + i];
      sums.wall += weight;
      add_sample(image.sectors()[moved.sector[i]], moved, i, weight, inverse_tolerance, sums);
    }
  }
  return sums;
}

/// Turns the sums' derivatives b of the image's frame into those of the pose by the 3 x 3 matrix A.
Alignment alignment_from(const Sums& sums, const Eigen::Matrix3d& A) {
  Eigen::Matrix3d products;
  products << sums.xx, sums.xy, sums.xt,  //
      sums.xy, sums.yy, sums.yt,          //
      sums.xt, sums.yt, sums.tt;
  Alignment result;
  result.evidence = {sums.wall, sums.agreeing, sums.contradicted, sums.hidden, sums.outside};
  result.hessian = A * products * A.transpose();
  result.gradient = A * Eigen::Vector3d(sums.gx, sums.gy, sums.gt);
  return result;
}

}  // namespace

Evidence& Evidence::operator+=(const Evidence& other) {
  wall_m += other.wall_m;
  agreeing_m += other.agreeing_m;
  contradicted_m += other.contradicted_m;
  hidden_m += other.hidden_m;
  outside_m += other.outside_m;
  return *this;
}

Alignment align_one_way(const SurfaceImage& image_a,
                        const SurfaceSamples& samples_b,
                        const Pose2& T_a_b,
                        double tolerance_m) {
  // q = R p + t: d distance / d theta = n_y (q - t)_x - n_x (q - t)_y.
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
  A(2, 0) = T_a_b.y_m;
  A(2, 1) = -T_a_b.x_m;
  return alignment_from(sum_over_samples(image_a, samples_b, T_a_b, tolerance_m), A);
}

Alignment align(const AlignedScan& reference,
                const AlignedScan& current,
                const Pose2& T_reference_current,
                double tolerance_m) {
  Alignment result =
      align_one_way(reference.image, current.samples, T_reference_current, tolerance_m);
  // q = R^T (r - t): the current's normals n turn into -R n, and a turn of the pose turns q back.
  const double c = std::cos(T_reference_current.theta_rad);
  const double s = std::sin(T_reference_current.theta_rad);
  Eigen::Matrix3d A;
  A << -c, s, 0.0,  //
      -s, -c, 0.0,  //
      0.0, 0.0, -1.0;
  const Alignment backward = alignment_from(
      sum_over_samples(
          current.image, reference.samples, T_reference_current.inverse(), tolerance_m),
      A);
  result.evidence += backward.evidence;
  result.hessian += backward.hessian;
  result.gradient += backward.gradient;
  return result;
}

}  // namespace setsquare
