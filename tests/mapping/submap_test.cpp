// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/loops/submap.hpp"

#include <gtest/gtest.h>

#include "tests/mapping/tracked_world.hpp"
#include "tests/support/pose_matchers.hpp"

namespace setsquare::submap_test {

using testing::between;
using testing::PoseNear;
using testing::PoseTolerance;
using testing::Wall;

std::vector<Pose2> poses_in_the_room() {
  return testing::spaced(testing::drive(testing::way_around_the_room()));
}

double distance_to_wall_m(const Wall& wall, const Eigen::Vector2d& p) {
  const Eigen::Vector2d a(wall.x1_m, wall.y1_m);
  const Eigen::Vector2d b(wall.x2_m, wall.y2_m);
  const double share = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - share * (b - a)).norm();
}

TEST(Submap, HoldsItsNeighboursWithinTheStretch) {
  const std::vector<Pose2> poses = poses_in_the_room();
  KeyframeTrack track = testing::track_in_world(testing::l_shaped_room(), poses, 0.0);
  for (std::size_t k = 20; k < track.size(); ++k) track.stretches[k] = 1;
  const auto members_about = [&](std::size_t middle) {
    const Submap submap = make_submap(track, poses, middle, 3);
    EXPECT_EQ(submap.keyframe, middle);
    EXPECT_EQ(submap.members[submap.middle_member], track.keyframes[middle].get());
    EXPECT_EQ(submap.images.size(), submap.members.size());
    return submap.members;
  };
  EXPECT_EQ(members_about(0).size(), 4U);
  EXPECT_EQ(members_about(10).size(), 7U);
  EXPECT_EQ(members_about(10).front(), track.keyframes[7].get());
  EXPECT_EQ(members_about(18).back(), track.keyframes[19].get());
  EXPECT_EQ(members_about(20).front(), track.keyframes[20].get());
  EXPECT_EQ(members_about(track.size() - 1).size(), 4U);
}

TEST(Submap, StandsInTheFrameOfItsMiddle) {
  const std::vector<Pose2> poses = poses_in_the_room();
  const KeyframeTrack track = testing::track_in_world(testing::l_shaped_room(), poses, 0.0);
  const Submap submap = make_submap(track, poses, 10, 3);
  for (std::size_t m = 0; m < submap.members.size(); ++m) {
    EXPECT_THAT(submap.images[m].T_submap_sensor,
                PoseNear(between(poses[10], poses[7 + m]), PoseTolerance{}));
  }
}

TEST(Submap, ItsSamplesLieOnTheWalls) {
  const std::vector<Pose2> poses = poses_in_the_room();
  const auto walls = testing::l_shaped_room();
  const KeyframeTrack track = testing::track_in_world(walls, poses, 0.0);
  const Submap submap = make_submap(track, poses, 15, 3);
  EXPECT_GT(submap.fine.size(), submap.coarse.size());
  EXPECT_LE(submap.coarse.size(), static_cast<std::size_t>(CorrelationGrid::kMaxSamples));
  for (const SurfaceSamples* samples : {&submap.coarse, &submap.fine}) {
    ASSERT_GT(samples->size(), 20U);
    for (std::size_t i = 0; i < samples->size(); ++i) {
      const Eigen::Vector2d p = poses[15] * Eigen::Vector2d(samples->x_m[i], samples->y_m[i]);
      double nearest_m = 1e9;
      for (const Wall& wall : walls) {
        nearest_m = std::min(nearest_m, distance_to_wall_m(wall, p));
      }
      EXPECT_LT(nearest_m, 1e-4);
    }
  }
}

}  // namespace setsquare::submap_test
