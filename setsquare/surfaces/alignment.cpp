// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/surfaces/alignment.hpp"

#include <cmath>

#include "setsquare/surfaces/lanes.hpp"
#include "setsquare/surfaces/sector_lanes.hpp"

namespace setsquare {
namespace {

/// Sums over the samples, a lane each; the six products and three moments of b = (n_x, n_y,
/// n_y q_x - n_x q_y), the derivative of a distance by a motion of the image's frame.
struct Sums {
  Floats wall{}, agreeing{}, contradicted{}, hidden{}, outside{};
  Floats xx{}, xy{}, yy{}, xt{}, yt{}, tt{};
  Floats gx{}, gy{}, gt{};
};

struct MovedLanes {
  Floats x, y, normal_x, normal_y;
};

void add_samples(const SectorLanes& sector,
                 const MovedLanes& moved,
                 Floats weight,
                 Floats inverse_tolerance,
                 Sums& sums) {
  const Floats zero{};
  const Floats distance = sector.normal_x * moved.x + sector.normal_y * moved.y - sector.offset_m;
  const Floats u = distance * inverse_tolerance;
  const Floats nearness = 1.0F - u * u;
  const Ints is_near = nearness > zero;
  const Floats cosine = sector.normal_x * moved.normal_x + sector.normal_y * moved.normal_y;
  const Ints has_normal = (moved.normal_x != zero) | (moved.normal_y != zero);
  const Floats facing = where(has_normal & (cosine > spread(kMinNormalCosine)), spread(1.0F)) +
                        where(~has_normal, spread(kClutterWeight));
  const Floats agreeing = where(is_near, weight * facing * nearness);

  const Ints is_unseen = distance < spread(-kHalfNoSurface_m);
  const Ints is_before = (distance > zero) | is_unseen;
  const Ints is_seen_through =
      (moved.x * moved.x + moved.y * moved.y < sector.free_square_m2) & is_before & ~is_near;
  sums.wall += weight;
  sums.agreeing += agreeing;
  sums.contradicted += where(is_seen_through, weight);
  sums.outside += where(is_unseen & ~is_seen_through, weight);
  sums.hidden += where(~(is_near | is_before), weight);

  const Floats w = agreeing * where(is_near, nearness);
  const Floats bt = sector.normal_y * moved.x - sector.normal_x * moved.y;
  const Floats wx = w * sector.normal_x;
  const Floats wy = w * sector.normal_y;
  const Floats wt = w * bt;
  const Floats near_distance = where(is_near, distance);
  sums.xx += wx * sector.normal_x;
  sums.xy += wx * sector.normal_y;
  sums.yy += wy * sector.normal_y;
  sums.xt += wx * bt;
  sums.yt += wy * bt;
  sums.tt += wt * bt;
  sums.gx += wx * near_distance;
  sums.gy += wy * near_distance;
  sums.gt += wt * near_distance;
}

Sums sum_over_samples(const SurfaceImage& image,
                      const SurfaceSamples& samples,
                      const Pose2& T_a_b,
                      double tolerance_m) {
  const Floats c = spread(static_cast<float>(std::cos(T_a_b.theta_rad)));
  const Floats s = spread(static_cast<float>(std::sin(T_a_b.theta_rad)));
  const Floats tx = spread(static_cast<float>(T_a_b.x_m));
  const Floats ty = spread(static_cast<float>(T_a_b.y_m));
  const Floats inverse_tolerance = spread(static_cast<float>(1.0 / tolerance_m));
  const SurfaceSector* sectors = image.sectors().data();
  Sums sums;
  for (std::size_t i = 0; i < samples.padded_size(); i += kLanes) {
    const Floats x = load_lanes(&samples.x_m[i]);
    const Floats y = load_lanes(&samples.y_m[i]);
    const Floats nx = load_lanes(&samples.normal_x[i]);
    const Floats ny = load_lanes(&samples.normal_y[i]);
    const MovedLanes moved{
        c * x - s * y + tx, s * x + c * y + ty, c * nx - s * ny, s * nx + c * ny};
    const SectorLanes sector = gather(sectors, image.sector_indices(moved.x, moved.y));
    add_samples(sector, moved, load_lanes(&samples.weight_m[i]), inverse_tolerance, sums);
  }
  return sums;
}

/// Turns the sums' derivatives b of the image's frame into those of the pose by the 3 x 3 matrix A.
Alignment alignment_from(const Sums& sums, const Eigen::Matrix3d& A) {
  Eigen::Matrix3d products;
  products << sum_of(sums.xx), sum_of(sums.xy), sum_of(sums.xt),  //
      sum_of(sums.xy), sum_of(sums.yy), sum_of(sums.yt),          //
      sum_of(sums.xt), sum_of(sums.yt), sum_of(sums.tt);
  Alignment result;
  result.evidence = {sum_of(sums.wall),
                     sum_of(sums.agreeing),
                     sum_of(sums.contradicted),
                     sum_of(sums.hidden),
                     sum_of(sums.outside)};
  result.hessian = A * products * A.transpose();
  result.gradient = A * Eigen::Vector3d(sum_of(sums.gx), sum_of(sums.gy), sum_of(sums.gt));
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
