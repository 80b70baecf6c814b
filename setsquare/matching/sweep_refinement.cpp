// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/sweep_refinement.hpp"

#include <cmath>
#include <cstddef>
#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "setsquare/core/approximate_bearing.hpp"
#include "setsquare/surfaces/alignment.hpp"

namespace setsquare {
namespace {

/// Distances of samples nearer than this along the wall share one cause.
constexpr float kPieceLength_m = 0.25F;
/// Standard deviation of what a whole piece is off by, though its own samples do not show it.
constexpr double kUnevenness_m = 0.005;

float wrapped(float angle_rad) {
  constexpr float kHalfTurn = static_cast<float>(kPi);
  if (angle_rad >= kHalfTurn) return angle_rad - 2.0F * kHalfTurn;
  return angle_rad < -kHalfTurn ? angle_rad + 2.0F * kHalfTurn : angle_rad;
}

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
};

struct Moved {
  float x, y, normal_x, normal_y, bearing_a_rad;
};

/// Where a sample lies in a's frame, both sweeps straightened.
Moved move(const OneWay& way, float cosine, float sine, std::size_t i) {
  const SurfaceSamples& samples = way.b.samples;
  const float late = way.turn_b * way.b.from_middle_rad[i];
  const float bx = samples.x_m[i] - late * samples.y_m[i];
  const float by = samples.y_m[i] + late * samples.x_m[i];
  const float x = cosine * bx - sine * by + static_cast<float>(way.T_a_b.x_m);
  const float y = sine * bx + cosine * by + static_cast<float>(way.T_a_b.y_m);
  const float bearing_rad =
      wrapped(approximate_bearing(y, x) - static_cast<float>(way.a.middle_rad));
  const float early = -way.turn_a * bearing_rad;
  return {x - early * y,
          y + early * x,
          cosine * samples.normal_x[i] - sine * samples.normal_y[i],
          sine * samples.normal_x[i] + cosine * samples.normal_y[i],
          bearing_rad};
}

float facing_weight(const Moved& moved, const SurfaceSector& sector) {
  if (moved.normal_x == 0.0F && moved.normal_y == 0.0F) return kClutterWeight;
  const float cosine = moved.normal_x * sector.normal_x + moved.normal_y * sector.normal_y;
  return cosine > kMinNormalCosine ? 1.0F : 0.0F;
}

/// The derivative of a sample's distance by pose and turns.
Vector5 derivative(const OneWay& way,
                   const Moved& moved,
                   const SurfaceSector& sector,
                   float from_middle_rad) {
  const double nx = sector.normal_x;
  const double ny = sector.normal_y;
  const double lever_a_m = ny * moved.x - nx * moved.y;
  const double lever_b_m = lever_a_m - (ny * way.T_a_b.x_m - nx * way.T_a_b.y_m);
  Vector5 j;
  j.head<3>() = way.A * Eigen::Vector3d(nx, ny, lever_a_m);
  j(way.a_row) = -static_cast<double>(moved.bearing_a_rad) * lever_a_m;
  j(way.b_row) = static_cast<double>(from_middle_rad) * lever_b_m;
  return j;
}

void close(Piece& piece, SweepNormal& normal) {
  normal.gradient += piece.pull;
  normal.scatter += piece.pull * piece.pull.transpose() +
                    kUnevenness_m * kUnevenness_m * piece.weight * piece.weight.transpose();
  piece = {};
}

void add_one_way(const OneWay& way, SweepNormal& normal) {
  const float cosine = static_cast<float>(std::cos(way.T_a_b.theta_rad));
  const float sine = static_cast<float>(std::sin(way.T_a_b.theta_rad));
  Piece piece;
  for (std::size_t i = 0; i < way.b.samples.size(); ++i) {
    const Moved moved = move(way, cosine, sine, i);
    const SurfaceSector& sector = way.a.image.at(moved.x, moved.y);
    const float distance_m = SurfaceImage::signed_distance_m(sector, moved.x, moved.y);
    const float u = distance_m * way.inverse_tolerance;
    const float nearness = 1.0F - u * u;
    if (nearness > 0.0F) {
      const float length_m = way.b.samples.weight_m[i];
      const double w = length_m * facing_weight(moved, sector) * nearness * nearness;
      const Vector5 j = derivative(way, moved, sector, way.b.from_middle_rad[i]);
      normal.hessian.noalias() += (w * j) * j.transpose();
      piece.pull += (w * static_cast<double>(distance_m)) * j;
      piece.weight += w * j;
    }
    piece.length_m += way.b.samples.weight_m[i];
    if (piece.length_m >= kPieceLength_m) close(piece, normal);
  }
  close(piece, normal);
}

constexpr int kNumSteps = 3;
/// Standard deviation of a turn, before the scans are seen.
constexpr double kTurnSigma = 0.002;
/// Variance of a distance times the length of wall over which it stays: what the prior is worth
/// against a metre of wall.
constexpr double kWallVariance_m3 = 2.5e-5;
constexpr double kTurnWeight = kWallVariance_m3 / (kTurnSigma * kTurnSigma);
/// Holds the pose along a direction that no wall determines, as in `refine`.
constexpr double kSweepDamping = 0.01;

/// The pose's equations once the turns have been solved for: Schur complement and its scatter.
MatchNormal with_turns_free(const SweepNormal& normal) {
  const Eigen::Matrix<double, 3, 2> coupling = normal.hessian.topRightCorner<3, 2>();
  const Eigen::Matrix2d turns =
      normal.hessian.bottomRightCorner<2, 2>() + kTurnWeight * Eigen::Matrix2d::Identity();
  Eigen::Matrix<double, 3, 5> reduce;
  reduce.leftCols<3>().setIdentity();
  reduce.rightCols<2>() = -coupling * turns.inverse();
  Matrix5 scatter = normal.scatter;
  scatter.bottomRightCorner<2, 2>() += kTurnWeight * kWallVariance_m3 * Eigen::Matrix2d::Identity();
  return {.hessian =
              normal.hessian.topLeftCorner<3, 3>() + reduce.rightCols<2>() * coupling.transpose(),
          .scatter = reduce * scatter * reduce.transpose()};
}

}  // namespace

std::vector<float> bearings_from(double middle_rad, const SurfaceSamples& samples) {
  std::vector<float> bearings_rad(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    bearings_rad[i] = wrapped(approximate_bearing(samples.y_m[i], samples.x_m[i]) -
                              static_cast<float>(middle_rad));
  }
  return bearings_rad;
}

SweepNormal sweep_normal(const SweptScan& reference,
                         const SweptScan& current,
                         const Pose2& T,
                         const SweepTurns& turns,
                         double tolerance_m) {
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
               inverse_tolerance},
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
               inverse_tolerance},
              normal);
  return normal;
}

SweepRefinement refine_with_turns(const SweptScan& reference,
                                  const SweptScan& current,
                                  const Pose2& T_reference_current,
                                  double tolerance_m) {
  Pose2 T = T_reference_current;
  SweepTurns turns;
  for (int step = 0; step < kNumSteps; ++step) {
    SweepNormal normal = sweep_normal(reference, current, T, turns, tolerance_m);
    normal.hessian.diagonal().head<3>().array() += kSweepDamping;
    normal.hessian.diagonal().tail<2>().array() += kTurnWeight;
    normal.gradient(3) += kTurnWeight * turns.reference;
    normal.gradient(4) += kTurnWeight * turns.current;
    const Vector5 d = -normal.hessian.ldlt().solve(normal.gradient);
    T = {T.x_m + d(0), T.y_m + d(1), wrap_to_pi(T.theta_rad + d(2))};
    turns = {turns.reference + d(3), turns.current + d(4)};
  }
  const SweepNormal normal = sweep_normal(reference, current, T, turns, tolerance_m);
  return {T, turns, normal.hessian.topLeftCorner<3, 3>(), with_turns_free(normal)};
}

}  // namespace setsquare
