// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "setsquare/matching/sweep_refinement.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::sweep_normal_test {

using testing::uniform;

constexpr double kTolerance_m = 0.1;

/// Pose and turns that the distances depend on.
using State = Vector5;

Pose2 pose_of(const State& state) { return {state(0), state(1), state(2)}; }

/// One sample of scan b against scan a, in double precision and plain code.
struct PlainSample {
  const SweptScan& a;
  const SweptScan& b;
  bool is_backward;  ///< The pose maps a's frame into b's.
  std::size_t i;

  /// Where the sample lies in a's frame once both sweeps are straightened, and its bearing there
  /// from the middle of a's sweep (`frozen_rad`, if any, replaces it).
  [[nodiscard]] Eigen::Vector2d place(const State& state, const double* frozen_rad) const {
    const double turn_a = state(is_backward ? 4 : 3);
    const double turn_b = state(is_backward ? 3 : 4);
    const Eigen::Vector2d p(b.samples.x_m[i], b.samples.y_m[i]);
    const Eigen::Vector2d straight =
        p + turn_b * b.from_middle_rad[i] * Eigen::Vector2d(-p.y(), p.x());
    const Pose2 T_a_b = is_backward ? pose_of(state).inverse() : pose_of(state);
    const Eigen::Vector2d q = T_a_b * straight;
    const double bearing_rad = frozen_rad ? *frozen_rad : bearing_in_a(q);
    return q - turn_a * bearing_rad * Eigen::Vector2d(-q.y(), q.x());
  }
  [[nodiscard]] double bearing_in_a(const Eigen::Vector2d& q) const {
    return wrap_to_pi(std::atan2(q.y(), q.x()) - a.middle_rad);
  }
  [[nodiscard]] double bearing_in_a(const State& state) const {
    State still = state;
    still(is_backward ? 4 : 3) = 0.0;
    return bearing_in_a(place(still, nullptr));
  }
  /// The share of its length that counts, before nearness.
  [[nodiscard]] double facing(const State& state, const SurfaceSector& sector) const {
    const Eigen::Vector2d normal(b.samples.normal_x[i], b.samples.normal_y[i]);
    if (normal.norm() < 0.5) return 0.3;
    const double theta_rad = is_backward ? -state(2) : state(2);
    const Eigen::Vector2d turned = Pose2{0.0, 0.0, theta_rad} * normal;
    return turned.dot(Eigen::Vector2d(sector.normal_x, sector.normal_y)) > 0.7 ? 1.0 : 0.0;
  }
};

double distance_m(const SurfaceSector& sector, const Eigen::Vector2d& q) {
  return sector.normal_x * q.x() + sector.normal_y * q.y() - sector.offset_m;
}

/// Derivatives by finite differences of the distances, with weights, sectors and bearings frozen.
void add_plain(const SweptScan& a,
               const SweptScan& b,
               bool is_backward,
               const State& state,
               SweepNormal& sum) {
  double piece_m = 0.0;
  Vector5 pull = Vector5::Zero();
  Vector5 weight = Vector5::Zero();
  for (std::size_t i = 0; i < b.samples.size(); ++i) {
    const PlainSample sample{a, b, is_backward, i};
    const double bearing_rad = sample.bearing_in_a(state);
    const Eigen::Vector2d q = sample.place(state, &bearing_rad);
    const SurfaceSector& sector = a.image.at(static_cast<float>(q.x()), static_cast<float>(q.y()));
    const double distance = distance_m(sector, q);
    if (std::abs(distance) < kTolerance_m) {
      const double nearness = 1.0 - std::pow(distance / kTolerance_m, 2);
      const double w = b.samples.weight_m[i] * sample.facing(state, sector) * nearness * nearness;
      Vector5 j;
      for (int k = 0; k < 5; ++k) {
        const Vector5 step = 1e-6 * Vector5::Unit(k);
        j(k) = (distance_m(sector, sample.place(state + step, &bearing_rad)) -
                distance_m(sector, sample.place(state - step, &bearing_rad))) /
               2e-6;
      }
      sum.hessian += w * j * j.transpose();
      sum.gradient += w * distance * j;
      pull += w * distance * j;
      weight += w * j;
    }
    piece_m += b.samples.weight_m[i];
    if (piece_m < 0.25 && i + 1 < b.samples.size()) continue;
    sum.scatter += pull * pull.transpose() + 0.005 * 0.005 * weight * weight.transpose();
    pull.setZero();
    weight.setZero();
    piece_m = 0.0;
  }
}

/// Two scans of one room, a current pose a little off the truth.
struct Pair {
  PreparedScan reference;
  PreparedScan current;
  Pose2 T;
};

Pair random_pair(std::mt19937_64& generator) {
  const testing::Fan fan{1081, rad_from_deg(-135), rad_from_deg(0.25)};
  const auto room = testing::furnished_room(generator);
  const Pose2 T_world_reference = testing::free_pose(room, generator);
  const Pose2 step{
      uniform(generator, -0.3, 0.3), uniform(generator, -0.3, 0.3), uniform(generator, -1.0, 1.0)};
  const Pose2 T_world_current = T_world_reference * step;
  const Pose2 slip{uniform(generator, -0.03, 0.03),
                   uniform(generator, -0.03, 0.03),
                   uniform(generator, -0.01, 0.01)};
  const auto scan = [&](const Pose2& T) {
    return prepare(testing::scan_of_walls(room.walls, T, fan, 0.01, generator()));
  };
  return {scan(T_world_reference),
          scan(T_world_current),
          T_world_reference.inverse() * T_world_current * slip};
}

/// Largest difference, each entry by its own scale: the roots of the diagonal.
double difference(const Matrix5& a, const Matrix5& b) {
  const Vector5 scale = b.diagonal().cwiseSqrt().cwiseInverse();
  return (scale.asDiagonal() * (a - b) * scale.asDiagonal()).cwiseAbs().maxCoeff();
}

// Sums of floats, an arc tangent of 0.005 rad, and samples on the border of a sector that may be
// judged by either; the scatter squares what a piece of wall sums up.
TEST(SweepNormal, IsThePlainSumOverTheSamples) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 20; ++trial) {
    const Pair pair = random_pair(generator);
    const SweepTurns turns{uniform(generator, -0.008, 0.008), uniform(generator, -0.008, 0.008)};
    const SweptScan reference = pair.reference.swept();
    const SweptScan current = pair.current.swept();
    const SweepNormal fast = sweep_normal(reference, current, pair.T, turns, kTolerance_m);
    State state;
    state << pair.T.x_m, pair.T.y_m, pair.T.theta_rad, turns.reference, turns.current;
    SweepNormal plain;
    add_plain(reference, current, false, state, plain);
    add_plain(current, reference, true, state, plain);
    EXPECT_LT(difference(fast.hessian, plain.hessian), 0.02);
    EXPECT_LT(difference(fast.scatter, plain.scatter), 0.1);
    const Vector5 scale = plain.hessian.diagonal().cwiseSqrt() * std::sqrt(kTolerance_m);
    EXPECT_LT((fast.gradient - plain.gradient).cwiseQuotient(scale).cwiseAbs().maxCoeff(), 0.01);
  }
}

TEST(SweepNormal, WithoutTurnsHoldsTheEquationsOfTheAlignment) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 20; ++trial) {
    const Pair pair = random_pair(generator);
    const SweepNormal swept =
        sweep_normal(pair.reference.swept(), pair.current.swept(), pair.T, {}, kTolerance_m);
    const Alignment rigid = align(
        pair.reference.dense_alignment(), pair.current.dense_alignment(), pair.T, kTolerance_m);
    const Eigen::Matrix3d hessian = swept.hessian.topLeftCorner<3, 3>();
    EXPECT_LT((hessian - rigid.hessian).norm(), 1e-3 * rigid.hessian.norm());
    EXPECT_LT((swept.gradient.head<3>() - rigid.gradient).norm(),
              1e-3 * kTolerance_m * rigid.hessian.norm());
  }
}

TEST(SweepNormal, BearingsCountFromTheMiddleOfTheSweep) {
  SurfaceSamples samples;
  samples.x_m = {1.0F, 0.0F, -1.0F, 0.0F};
  samples.y_m = {0.0F, 2.0F, -0.1F, -3.0F};
  samples.count = 4;
  const auto bearings_rad = bearings_from(0.5 * kPi, samples);
  EXPECT_NEAR(bearings_rad[0], -0.5 * kPi, 0.006);
  EXPECT_NEAR(bearings_rad[1], 0.0, 0.006);
  EXPECT_NEAR(bearings_rad[2], std::atan2(-0.1, -1.0) + 1.5 * kPi, 0.006);
  EXPECT_NEAR(std::abs(bearings_rad[3]), kPi, 0.006);
}

}  // namespace setsquare::sweep_normal_test
