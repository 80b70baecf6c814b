// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/sweep_refinement.hpp"

#include <cmath>
#include <cstddef>
#include <Eigen/LU>

#include "setsquare/core/damped_step.hpp"
#include "setsquare/surfaces/sample_comparison.hpp"

namespace setsquare {
namespace {

/// One piece of wall: what its distances pull, and what they weigh.
struct Piece {
  float length_m = 0.0F;
  Vector5 pull = Vector5::Zero();
  Vector5 weight = Vector5::Zero();
};

/// One way: samples of frame b against the image of frame a. Rows of A turn derivatives by a motion
/// of a's frame into those of the pose; `a_row` and `b_row` are those of the two turns.
struct OneWay {
  const SweptScan& a;
  const SweptScan& b;
  Pose2 T_a_b;
  Eigen::Matrix3d A;
  float turn_a;
  float turn_b;
  int a_row;
  int b_row;
  float inverse_tolerance;
  const SweepParams& params;
};

/// A sample in a's frame, both sweeps straightened, and its bearing from the middle of a's sweep.
struct StraightenedSample {
  MovedSample<float> moved;
  float bearing_a_rad;
};

StraightenedSample straightened(const OneWay& way, const Motion<float>& T, std::size_t i) {
  const SurfaceSamples& samples = way.b.samples;
  const float late = way.turn_b * way.b.from_middle_rad[i];
  MovedSample<float> moved = moved_sample(T,
                                          samples.x_m[i] - late * samples.y_m[i],
                                          samples.y_m[i] + late * samples.x_m[i],
                                          samples.normal_x[i],
                                          samples.normal_y[i]);
  const float x_m = moved.x_m;
  const float y_m = moved.y_m;
  const float bearing_rad = bearing_from(static_cast<float>(way.a.middle_rad), x_m, y_m);
  const float early = -way.turn_a * bearing_rad;
  moved.x_m = x_m - early * y_m;
  moved.y_m = y_m + early * x_m;
  return {moved, bearing_rad};
}

/// The derivative of a sample's distance by pose and turns.
Vector5 derivative(const OneWay& way,
                   const SampleComparison<float>& compared,
                   float bearing_a_rad,
                   float from_middle_rad) {
  const double nx = compared.sector.normal_x;
  const double ny = compared.sector.normal_y;
  const double lever_a_m = ny * compared.sample.x_m - nx * compared.sample.y_m;
  const double lever_b_m = lever_a_m - (ny * way.T_a_b.x_m - nx * way.T_a_b.y_m);
  Vector5 j;
  j.head<3>() = way.A * Eigen::Vector3d(nx, ny, lever_a_m);
  j(way.a_row) = -static_cast<double>(bearing_a_rad) * lever_a_m;
  j(way.b_row) = static_cast<double>(from_middle_rad) * lever_b_m;
  return j;
}

void close(Piece& piece, double unevenness_m, SweepNormal& normal) {
  normal.gradient += piece.pull;
  normal.scatter += piece.pull * piece.pull.transpose() +
                    unevenness_m * unevenness_m * piece.weight * piece.weight.transpose();
  piece = {};
}

void add_one_way(const OneWay& way, SweepNormal& normal) {
  const Motion<float> T(way.T_a_b);
  const auto piece_length_m = static_cast<float>(way.params.piece_length_m);
  Piece piece;
  for (std::size_t i = 0; i < way.b.samples.size(); ++i) {
    const StraightenedSample sample = straightened(way, T, i);
    const SampleComparison<float> compared(way.a.image, sample.moved);
    const float nearness = compared.nearness(way.inverse_tolerance);
    if (nearness > 0.0F) {
      const float length_m = way.b.samples.weight_m[i];
      const double w = length_m * facing_weight(compared) * nearness * nearness;
      const Vector5 j = derivative(way, compared, sample.bearing_a_rad, way.b.from_middle_rad[i]);
      normal.hessian.noalias() += (w * j) * j.transpose();
      piece.pull += (w * static_cast<double>(compared.distance_m)) * j;
      piece.weight += w * j;
    }
    piece.length_m += way.b.samples.weight_m[i];
    if (piece.length_m >= piece_length_m) close(piece, way.params.unevenness_m, normal);
  }
  close(piece, way.params.unevenness_m, normal);
}

/// Holds the pose along a direction that no wall determines, as in `refine`; the turns are held by
/// their prior.
const Vector5 kPoseDamping{{0.01, 0.01, 0.01, 0.0, 0.0}};

NormalEquations<5> turns_near_zero(const SweepTurns& turns, double weight) {
  NormalEquations<5> prior;
  prior.hessian.diagonal().tail<2>().setConstant(weight);
  prior.gradient.tail<2>() << weight * turns.reference, weight * turns.current;
  return prior;
}

/// The pose's equations once the turns have been solved for: Schur complement and its scatter.
MatchNormal with_turns_free(const SweepNormal& normal, const SweepParams& params) {
  const Eigen::Matrix<double, 3, 2> coupling = normal.hessian.topRightCorner<3, 2>();
  const Eigen::Matrix2d turns =
      normal.hessian.bottomRightCorner<2, 2>() + params.turn_weight() * Eigen::Matrix2d::Identity();
  Eigen::Matrix<double, 3, 5> reduce;
  reduce.leftCols<3>().setIdentity();
  reduce.rightCols<2>() = -coupling * turns.inverse();
  Matrix5 scatter = normal.scatter;
  scatter.bottomRightCorner<2, 2>() +=
      params.turn_weight() * params.wall_variance_m3 * Eigen::Matrix2d::Identity();
  return {.hessian =
              normal.hessian.topLeftCorner<3, 3>() + reduce.rightCols<2>() * coupling.transpose(),
          .scatter = reduce * scatter * reduce.transpose()};
}

}  // namespace

SweepNormal sweep_normal(const SweptScan& reference,
                         const SweptScan& current,
                         const Pose2& T,
                         const SweepTurns& turns,
                         double tolerance_m,
                         const SweepParams& params) {
  constexpr int kReferenceRow = 3;
  constexpr int kCurrentRow = 4;
  const auto turn_reference = static_cast<float>(turns.reference);
  const auto turn_current = static_cast<float>(turns.current);
  const auto inverse_tolerance = static_cast<float>(1.0 / tolerance_m);
  SweepNormal normal;
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
  A(2, 0) = T.y_m;
  A(2, 1) = -T.x_m;
  add_one_way({reference,
               current,
               T,
               A,
               turn_reference,
               turn_current,
               kReferenceRow,
               kCurrentRow,
               inverse_tolerance,
               params},
              normal);
  const double c = std::cos(T.theta_rad);
  const double s = std::sin(T.theta_rad);
  A << -c, s, 0.0,  //
      -s, -c, 0.0,  //
      0.0, 0.0, -1.0;
  add_one_way({current,
               reference,
               T.inverse(),
               A,
               turn_current,
               turn_reference,
               kCurrentRow,
               kReferenceRow,
               inverse_tolerance,
               params},
              normal);
  return normal;
}

SweepRefinement refine_with_turns(const SweptScan& reference,
                                  const SweptScan& current,
                                  const Pose2& T_reference_current,
                                  double tolerance_m,
                                  const SweepParams& params) {
  Pose2 T = T_reference_current;
  SweepTurns turns;
  for (int iteration = 0; iteration < params.num_steps; ++iteration) {
    const SweepNormal normal = sweep_normal(reference, current, T, turns, tolerance_m, params);
    const Vector5 step = damped_step<5>({normal.hessian, normal.gradient},
                                        kPoseDamping,
                                        turns_near_zero(turns, params.turn_weight()));
    T = stepped(T, step.head<3>());
    turns = {turns.reference + step(3), turns.current + step(4)};
  }
  const SweepNormal normal = sweep_normal(reference, current, T, turns, tolerance_m, params);
  return {T, turns, normal.hessian.topLeftCorner<3, 3>(), with_turns_free(normal, params)};
}

}  // namespace setsquare
