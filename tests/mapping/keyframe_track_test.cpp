// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/keyframe_track.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/support/pose_matchers.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::keyframe_track_test {

using testing::PoseNear;
using testing::PoseTolerance;
using testing::uniform;

/// A random way: headings unwrapped.
std::vector<Pose2> random_way(std::size_t num, std::mt19937_64& generator) {
  std::vector<Pose2> poses{{1.0, -2.0, 0.3}};
  while (poses.size() < num) {
    const Pose2 next =
        poses.back() * Pose2{uniform(generator, -0.1, 0.6), uniform(generator, -0.2, 0.2), 0.0};
    poses.push_back({next.x_m, next.y_m, poses.back().theta_rad + uniform(generator, -0.5, 0.7)});
  }
  return poses;
}

/// A track without scans.
KeyframeTrack track_at(const std::vector<Pose2>& T_odom_sensor) {
  KeyframeTrack track;
  for (const Pose2& pose : T_odom_sensor) {
    Keyframe keyframe;
    keyframe.T_odom_sensor = {pose.x_m, pose.y_m, wrap_to_pi(pose.theta_rad)};
    keyframe.T_odom_body = keyframe.T_odom_sensor;
    track.keyframes.push_back(std::make_shared<Keyframe>(keyframe));
    track.motions.push_back({1e-4 * Eigen::Matrix2d::Identity(), 1e-5});
    track.stretches.push_back(0);
    track.pieces.push_back(0);
  }
  return track;
}

std::vector<double> headings_of(const std::vector<Pose2>& poses) {
  std::vector<double> headings_rad;
  for (const Pose2& pose : poses) headings_rad.push_back(pose.theta_rad);
  return headings_rad;
}

TEST(KeyframeTrack, HeadingsAsTrackedGiveTheTrack) {
  std::mt19937_64 generator = testing::make_generator();
  const std::vector<Pose2> way = random_way(60, generator);
  const PoseGraph graph = pose_graph_of(track_at(way), headings_of(way));
  ASSERT_EQ(graph.T_map_node.size(), way.size());
  ASSERT_EQ(graph.constraints.size(), way.size() - 1);
  for (std::size_t k = 0; k < way.size(); ++k) {
    const Pose2 expected{way[k].x_m - way[0].x_m, way[k].y_m - way[0].y_m, way[k].theta_rad};
    EXPECT_THAT(graph.T_map_node[k], PoseNear(expected, PoseTolerance{}));
  }
  for (const Constraint& constraint : graph.constraints) {
    EXPECT_LT(residual(graph, constraint).norm(), 1e-9);
    EXPECT_EQ(constraint.kind, ConstraintKind::kOdometry);
    EXPECT_EQ(constraint.to, constraint.from + 1);
  }
}

TEST(KeyframeTrack, TurnsOutADriftThatGrowsAllTheWay) {
  std::mt19937_64 generator = testing::make_generator();
  const std::vector<Pose2> truth = random_way(200, generator);
  std::vector<Pose2> tracked{truth[0]};
  double drift_rad = 0.0;
  for (std::size_t k = 1; k < truth.size(); ++k) {
    const double more_rad = uniform(generator, -0.02, 0.06);
    const Pose2 turn{0.0, 0.0, drift_rad + 0.5 * more_rad};
    const Eigen::Vector2d moved_m = turn * (truth[k].translation() - truth[k - 1].translation());
    drift_rad += more_rad;
    tracked.push_back({tracked.back().x_m + moved_m.x(),
                       tracked.back().y_m + moved_m.y(),
                       truth[k].theta_rad + drift_rad});
  }
  ASSERT_GT(drift_rad, 2.0);
  const PoseGraph graph = pose_graph_of(track_at(tracked), headings_of(truth));
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const Pose2 expected{
        truth[k].x_m - truth[0].x_m, truth[k].y_m - truth[0].y_m, truth[k].theta_rad};
    ASSERT_THAT(graph.T_map_node[k],
                PoseNear(expected, PoseTolerance{.translation_m = 1e-9, .rotation_rad = 1e-9}));
  }
  // The constraints keep the rotation that was tracked: the headings' fusion has judged it.
  const Constraint& last = graph.constraints.back();
  EXPECT_NEAR(wrap_to_pi(last.T_from_to.theta_rad -
                         (tracked.back().theta_rad - tracked[tracked.size() - 2].theta_rad)),
              0.0,
              1e-9);
}

TEST(KeyframeTrack, TheCovarianceIsTurnedIntoTheFrameOfTheKeyframeBefore) {
  std::mt19937_64 generator = testing::make_generator();
  const std::vector<Pose2> way = random_way(20, generator);
  KeyframeTrack track = track_at(way);
  for (MotionCovariance& motion : track.motions) {
    const double angle_rad = uniform(generator, -kPi, kPi);
    const Eigen::Vector2d u(std::cos(angle_rad), std::sin(angle_rad));
    motion.translation_m2 = 1e-4 * Eigen::Matrix2d::Identity() + 0.01 * u * u.transpose();
    motion.rotation_rad2 = uniform(generator, 1e-6, 1e-4);
  }
  const PoseGraph graph = pose_graph_of(track, headings_of(way));
  for (std::size_t k = 1; k < way.size(); ++k) {
    // How the measured translation follows that in the odom frame, by differences.
    Eigen::Matrix2d J;
    for (int axis = 0; axis < 2; ++axis) {
      constexpr double kStep_m = 1e-4;
      std::vector<Pose2> off = way;
      (axis == 0 ? off[k].x_m : off[k].y_m) += kStep_m;
      const PoseGraph moved = pose_graph_of(track_at(off), headings_of(off));
      J.col(axis) = (moved.constraints[k - 1].T_from_to.translation() -
                     graph.constraints[k - 1].T_from_to.translation()) /
                    kStep_m;
    }
    const Eigen::Matrix3d covariance = graph.constraints[k - 1].information.inverse();
    const Eigen::Matrix2d expected = J * track.motions[k].translation_m2 * J.transpose();
    const Eigen::Matrix2d translation = covariance.topLeftCorner<2, 2>();
    EXPECT_TRUE(translation.isApprox(expected, 1e-6)) << k;
    EXPECT_NEAR(covariance(2, 2), track.motions[k].rotation_rad2, 1e-12);
    EXPECT_LT(covariance.topRightCorner(2, 1).norm(), 1e-15);
  }
}

TEST(KeyframeTrack, NoKeyframesNoGraph) { EXPECT_TRUE(pose_graph_of({}, {}).T_map_node.empty()); }

}  // namespace setsquare::keyframe_track_test
