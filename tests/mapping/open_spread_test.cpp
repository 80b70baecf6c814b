// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/open_spread.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <Eigen/LU>

#include "setsquare/core/error.hpp"
#include "setsquare/graph/linear_pose_graph.hpp"
#include "setsquare/matching/information.hpp"
#include "setsquare/tracking/motion_uncertainty.hpp"
#include "setsquare/tracking/open_direction.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::open_spread_test {

constexpr double kStep_m = 0.4;
constexpr double kUsualSigma_m = 0.008;
constexpr double kOpenSigma_m = 0.2;

/// A straight track along x; each motion is open along a direction that is off x by `noise_rad`.
KeyframeTrack corridor(std::size_t num_motions, double noise_rad = 0.0) {
  std::mt19937_64 generator = testing::make_generator();
  std::normal_distribution<double> normal(0.0, 1.0);
  KeyframeTrack track;
  for (std::size_t k = 0; k <= num_motions; ++k) {
    Keyframe keyframe;
    keyframe.T_odom_sensor = {kStep_m * static_cast<double>(k), 0.0, 0.0};
    keyframe.T_odom_body = keyframe.T_odom_sensor;
    track.keyframes.push_back(std::make_shared<Keyframe>(keyframe));
    MotionCovariance motion{
        .translation_m2 = kUsualSigma_m * kUsualSigma_m * Eigen::Matrix2d::Identity(),
        .rotation_rad2 = 1e-6};
    if (k > 0) {
      const double off_rad = noise_rad * normal(generator);
      const Eigen::Vector2d u(std::cos(off_rad), std::sin(off_rad));
      motion.open_sigma_m = kOpenSigma_m * u * u.transpose();
      motion.translation_m2 += motion.open_sigma_m * motion.open_sigma_m;
    }
    track.motions.push_back(motion);
    track.stretches.push_back(0);
    track.pieces.push_back(0);
  }
  return track;
}

Eigen::Matrix2d sum_of(const KeyframeTrack& track) {
  Eigen::Matrix2d sum_m2 = Eigen::Matrix2d::Zero();
  const std::vector<double> turn_rad(track.size(), 0.0);
  const std::vector<Eigen::Matrix2d> covariances_m2 = motion_covariances_m2(track, turn_rad);
  for (std::size_t k = 1; k < track.size(); ++k) sum_m2 += covariances_m2[k];
  return sum_m2;
}

TEST(OpenSpread, SigmasOfOneStretchAddUp) {
  const KeyframeTrack track = corridor(50);
  const Eigen::Matrix2d sum_m2 = sum_of(track);
  EXPECT_NEAR(std::sqrt(sum_m2(0, 0)), 50 * kOpenSigma_m, 1e-3);
  EXPECT_NEAR(std::sqrt(sum_m2(1, 1)), std::sqrt(50.0) * kUsualSigma_m, 1e-9);
  // What variances that add up would say.
  double alone_m2 = 0.0;
  for (std::size_t k = 1; k < track.size(); ++k) alone_m2 += track.motions[k].translation_m2(0, 0);
  EXPECT_LT(std::sqrt(alone_m2), 0.2 * 50 * kOpenSigma_m);
}

TEST(OpenSpread, AScanThatTellsTheSpeedPartsTwoStretches) {
  KeyframeTrack track = corridor(50);
  for (std::size_t k = 26; k < track.size(); ++k) track.motions[k].open_stretch = 1;
  EXPECT_NEAR(std::sqrt(sum_of(track)(0, 0)), std::sqrt(2.0) * 25 * kOpenSigma_m, 1e-3);
}

TEST(OpenSpread, AMotionThatIsNotOpenKeepsItsCovariance) {
  KeyframeTrack track = corridor(3);
  track.motions[2].translation_m2 -= track.motions[2].open_sigma_m * track.motions[2].open_sigma_m;
  track.motions[2].open_sigma_m.setZero();
  const std::vector<double> turn_rad(track.size(), 0.4);
  EXPECT_TRUE(motion_covariances_m2(track, turn_rad)[2].isApprox(
      kUsualSigma_m * kUsualSigma_m * Eigen::Matrix2d::Identity(), 1e-12));
}

// Walls' normals are noisy: were each motion open along its own direction, the corridor could
// zigzag by metres to go a few centimetres across.
TEST(OpenSpread, AStraightCorridorIsOpenAlongOneDirection) {
  const KeyframeTrack track = corridor(50, 0.01);
  const std::vector<double> turn_rad(track.size(), 0.0);
  const std::vector<Eigen::Matrix2d> covariances_m2 = motion_covariances_m2(track, turn_rad);
  const Eigen::Vector2d along = open_direction(covariances_m2[1].inverse()).direction;
  const Eigen::Vector2d across(-along.y(), along.x());
  for (std::size_t k = 1; k < track.size(); ++k) {
    EXPECT_NEAR(std::sqrt(across.dot(covariances_m2[k] * across)), kUsualSigma_m, 0.002) << k;
  }
}

TEST(OpenSpread, ABentCorridorIsOpenAlongItself) {
  const KeyframeTrack track = corridor(50);
  std::vector<double> turn_rad;
  for (std::size_t k = 0; k < track.size(); ++k) {
    turn_rad.push_back(0.02 * static_cast<double>(k));
  }
  const std::vector<Eigen::Matrix2d> covariances_m2 = motion_covariances_m2(track, turn_rad);
  for (std::size_t k = 1; k < track.size(); ++k) {
    const Eigen::Vector2d across(-std::sin(turn_rad[k]), std::cos(turn_rad[k]));
    EXPECT_NEAR(std::sqrt(across.dot(covariances_m2[k] * across)), kUsualSigma_m, 1e-6) << k;
  }
}

// A clock that jumps by decades while the walls leave a direction open.
TEST(OpenSpread, NoMotionIsLargerThanABuilding) {
  KeyframeTrack track = corridor(50, 0.01);
  MotionUncertainty uncertainty{MotionUncertaintyParams{}};
  TrackedPose tracked{.status = TrackStatus::kDegenerate, .T_odom_sensor = {}, .open = {}};
  tracked.open = {.direction = {1.0, 0.0}, .effective_points = 0.0};
  tracked.open_bound_share = 0.0;
  (void)uncertainty.add(tracked, {0, Timestamp{}});
  (void)uncertainty.take();
  constexpr std::int64_t kSixtyYears_ns = 60LL * 365 * 86400 * 1'000'000'000;
  (void)uncertainty.add(tracked, {0, Timestamp{kSixtyYears_ns}});
  track.motions[25] = uncertainty.take();
  ASSERT_GT(track.motions[25].open_sigma_m(0, 0), 100.0);
  EXPECT_LT(std::sqrt(sum_of(track).trace()), 1.01 * kLargestOpenSigma_m);
  const std::vector<double> headings_rad(track.size(), 0.0);
  EXPECT_NEAR(solve_positions(pose_graph_of(track, headings_rad)).back().x(), 50 * kStep_m, 1e-6);
  // Bounds that are missing: the graph holds the node along one axis only.
  track.motions[25].open_sigma_m *= 1e6;
  track.motions[25].translation_m2 +=
      track.motions[25].open_sigma_m * track.motions[25].open_sigma_m;
  PoseGraph unbounded = pose_graph_of(track, headings_rad);
  unbounded.constraints[24].information.topLeftCorner<2, 2>() =
      track.motions[25].translation_m2.inverse();
  EXPECT_THROW((void)solve_positions(unbounded), ParameterError);
}

/// Closures between neighbours but five, as a bare corridor gives them: right across but for 4 mm,
/// open along a direction that is off by 0.1 deg, and along it nobody knows.
PoseGraph corridor_with_closures(const KeyframeTrack& track, std::mt19937_64& generator) {
  std::normal_distribution<double> normal(0.0, 1.0);
  const std::vector<double> headings_rad(track.size(), 0.0);
  PoseGraph graph = pose_graph_of(track, headings_rad);
  for (std::size_t k = 0; k + 5 < track.size(); k += 2) {
    const double off_rad = rad_from_deg(0.1) * normal(generator);
    Constraint closure;
    closure.from = k;
    closure.to = k + 5;
    closure.kind = ConstraintKind::kLoopClosure;
    closure.T_from_to = {kStep_m * 5.0, 0.004 * normal(generator), 0.0};
    closure.information =
        without_direction(Eigen::Vector3d(3e2, 3e4, 1e6).asDiagonal().toDenseMatrix(),
                          {std::cos(off_rad), std::sin(off_rad), 0.0});
    graph.constraints.push_back(closure);
  }
  return graph;
}

// A robot drove 40 m along a corridor, and its track happens to be right.
TEST(OpenSpread, ClosuresAcrossACorridorDoNotSetItsLength) {
  const KeyframeTrack track = corridor(100);
  const double length_m = 100 * kStep_m;
  std::mt19937_64 generator = testing::make_generator();
  double worst_without_m = 0.0;
  for (int draw = 0; draw < 20; ++draw) {
    PoseGraph graph = corridor_with_closures(track, generator);
    const auto off_m = [&] { return std::abs(solve_positions(graph).back().x() - length_m); };
    worst_without_m = std::max(worst_without_m, off_m());
    loosen_across(track.size() - 1, false, graph);
    EXPECT_LT(off_m(), 0.5);
  }
  EXPECT_GT(worst_without_m, 1.0) << "without the rule";
}

TEST(OpenSpread, AClosureAcrossAWayThatIsKnownCountsInFull) {
  const KeyframeTrack track = corridor(20);
  std::mt19937_64 generator = testing::make_generator();
  PoseGraph graph = corridor_with_closures(track, generator);
  const std::size_t first = track.size() - 1;  // The first closure, from 0 to 5.
  Constraint both;
  both.to = 5;
  both.kind = ConstraintKind::kLoopClosure;
  both.T_from_to = {kStep_m * 5.0, 0.0, 0.0};
  both.information = 1e4 * Eigen::Matrix3d::Identity();
  graph.constraints.push_back(both);
  for (std::size_t k = 0; k < track.size(); ++k) graph.headings.push_back({k, 0.0, 1e6});
  const double before = graph.constraints[first].information(1, 1);
  PoseGraph by_track = graph;
  loosen_across(track.size() - 1, false, by_track);
  EXPECT_LT(by_track.constraints[first].information(1, 1), 0.5 * before);
  loosen_across(track.size() - 1, true, graph);
  EXPECT_GT(graph.constraints[first].information(1, 1), 0.95 * before);
  EXPECT_EQ(graph.constraints.back().information, both.information) << "it binds both axes";
}

}  // namespace setsquare::open_spread_test
