// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/surfaces/alignment.hpp"

#include <cmath>

#include "setsquare/core/damped_step.hpp"
#include "setsquare/surfaces/lanes.hpp"
#include "setsquare/surfaces/sample_comparison.hpp"

namespace setsquare {
namespace {

/// The evidence's sums over the samples, four at a time, and the normal equations in a motion of
/// the image's frame.
struct EvidenceSums {
  Floats wall{}, agreeing{}, contradicted{}, hidden{}, outside{};
  LineSums lines;

  void add(const SampleComparison<Floats>& compared, Floats weight, Floats inverse_tolerance);
};

void EvidenceSums::add(const SampleComparison<Floats>& compared,
                       Floats weight,
                       Floats inverse_tolerance) {
  const Floats zero{};
  const Floats distance = compared.distance_m;
  const Floats nearness = compared.nearness(inverse_tolerance);
  const Ints is_near = nearness > zero;
  const Floats near_weight = where(is_near, weight * facing_weight(compared) * nearness);

  const Ints is_unseen = distance < spread(-kHalfNoSurface_m);
  const Ints is_before = (distance > zero) | is_unseen;
  const Ints is_seen_through = compared.is_in_free_space() & is_before & ~is_near;
  wall += weight;
  agreeing += near_weight;
  contradicted += where(is_seen_through, weight);
  outside += where(is_unseen & ~is_seen_through, weight);
  hidden += where(~(is_near | is_before), weight);
  lines.add(compared.sector,
            compared.lever_m(compared.sample.x_m, compared.sample.y_m),
            near_weight * where(is_near, nearness),
            where(is_near, distance));
}

EvidenceSums sum_over_samples(const SurfaceImage& image,
                              const SurfaceSamples& samples,
                              const Pose2& T_a_b,
                              double tolerance_m) {
  const Floats inverse_tolerance = spread(static_cast<float>(1.0 / tolerance_m));
  EvidenceSums sums;
  compare_by_fours(image, samples, T_a_b, [&](std::size_t first, const auto& compared) {
    sums.add(compared, load_lanes(&samples.weight_m[first]), inverse_tolerance);
  });
  return sums;
}

/// Turns the sums' derivatives by a motion of the image's frame into those of the pose by the 3 x 3
/// matrix A.
Alignment alignment_from(const EvidenceSums& sums, const Eigen::Matrix3d& A) {
  Alignment result;
  result.evidence = {sum_of(sums.wall),
                     sum_of(sums.agreeing),
                     sum_of(sums.contradicted),
                     sum_of(sums.hidden),
                     sum_of(sums.outside)};
  result.hessian = A * sums.lines.hessian() * A.transpose();
  result.gradient = A * sums.lines.gradient();
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

Pose2 refine(const AlignedScan& reference,
             const AlignedScan& current,
             const Pose2& T_reference_current,
             std::span<const double> tolerances_m) {
  // Holds the pose along a direction that no wall determines (m of wall, m of wall x m^2). Far less
  // than the wall that any accepted answer has, so that no result depends on it.
  constexpr double kAlignmentDamping = 0.01;
  Pose2 T = T_reference_current;
  for (const double tolerance_m : tolerances_m) {
    const Alignment alignment = align(reference, current, T, tolerance_m);
    T = stepped(T, quick_damped_step({alignment.hessian, alignment.gradient}, kAlignmentDamping));
  }
  return T;
}

}  // namespace setsquare
