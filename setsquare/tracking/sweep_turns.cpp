// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/sweep_turns.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "setsquare/core/damped_step.hpp"

namespace setsquare {
namespace {

/// Points that were measured at nearly the same time are moved as one.
constexpr std::size_t kNumParts = 8;
/// Of one point, correlated with its neighbours (RegistrationParams::point_sigma_m).
constexpr double kPointSigma_m = 0.10;
/// Of one step, for each half.
constexpr double kMaxStep_rad = 0.15;

using Vector5 = Eigen::Matrix<double, 5, 1>;

/// A part of a sweep: its points, and when they were measured.
struct SweepPart {
  SurfacePoints points;
  double sum_share = 0.0;

  [[nodiscard]] double share() const { return sum_share / static_cast<double>(points.size()); }
};

std::array<SweepPart, kNumParts> parts_of(const PlacedSweep& sweep) {
  std::array<SweepPart, kNumParts> parts;
  for (std::size_t i = 0; i < sweep.points.size(); ++i) {
    const double share = sweep.share[static_cast<std::size_t>(sweep.points.beam[i])];
    const auto part = static_cast<std::size_t>(0.5 * (share + 1.0) * kNumParts);
    SweepPart& its = parts[std::min(part, kNumParts - 1)];
    its.points.x_m.push_back(sweep.points.x_m[i]);
    its.points.y_m.push_back(sweep.points.y_m[i]);
    its.points.normal_x.push_back(sweep.points.normal_x[i]);
    its.points.normal_y.push_back(sweep.points.normal_y[i]);
    its.points.weight_m.push_back(sweep.points.weight_m[i]);
    its.sum_share += share;
  }
  return parts;
}

/// Of the step in (x, y, theta) of a part to that in (x, y, theta, turn before, turn after).
Eigen::Matrix<double, 3, 5> part_jacobian(double share) {
  Eigen::Matrix<double, 3, 5> jacobian = Eigen::Matrix<double, 3, 5>::Zero();
  jacobian.leftCols<3>().setIdentity();
  jacobian(2, share < 0.0 ? 3 : 4) = share;
  return jacobian;
}

NormalEquations<5> sweep_equations(const PlacedSweep& sweep,
                                   std::span<const PlacedImage> submap,
                                   const AlignmentScale& scale,
                                   PointMarks& marks) {
  NormalEquations<5> sum;
  for (const SweepPart& part : parts_of(sweep)) {
    if (part.points.size() == 0) continue;
    const SurfaceSamples samples = sample_surface(part.points, part.points.size());
    const SubmapAlignment alignment =
        align_with_submap(submap, samples, sweep.T_odom_sensor, scale, marks);
    const Eigen::Matrix<double, 3, 5> jacobian = part_jacobian(part.share());
    sum.hessian += jacobian.transpose() * alignment.hessian * jacobian;
    sum.gradient += jacobian.transpose() * alignment.gradient;
  }
  return sum;
}

}  // namespace

SweepMotion refined_turns(const PlacedSweep& sweep,
                          const SweepMotion& expected,
                          double sigma_rad,
                          std::span<const PlacedImage> submap,
                          const AlignmentScale& scale,
                          PointMarks& marks) {
  constexpr double kDamping = 1e-3;
  const NormalEquations<5> data = sweep_equations(sweep, submap, scale, marks);
  const double weight = (kPointSigma_m * kPointSigma_m) / (sigma_rad * sigma_rad);
  NormalEquations<5> prior;
  prior.hessian(3, 3) = prior.hessian(4, 4) = weight;
  prior.gradient(3) = weight * (sweep.motion.turn_before_rad - expected.turn_before_rad);
  prior.gradient(4) = weight * (sweep.motion.turn_after_rad - expected.turn_after_rad);
  const Vector5 step = damped_step<5>(data, Vector5::Constant(kDamping), prior);
  SweepMotion refined = sweep.motion;
  refined.turn_before_rad += std::clamp(step(3), -kMaxStep_rad, kMaxStep_rad);
  refined.turn_after_rad += std::clamp(step(4), -kMaxStep_rad, kMaxStep_rad);
  return refined;
}

}  // namespace setsquare
