// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "setsquare/mapping/keyframe_track.hpp"
#include "tests/support/pose_matchers.hpp"

namespace setsquare::track_assembly_test {

using testing::PoseNear;
using testing::PoseTolerance;

/// A curve as tracked, beginning at the origin.
std::vector<Pose2> curve() {
  std::vector<Pose2> poses{{}};
  for (int i = 1; i < 60; ++i) poses.push_back(poses.back() * Pose2{0.1, 0.002, 0.03});
  return poses;
}

std::vector<MappedKeyframe> keyframes_of(const std::vector<Pose2>& poses,
                                         const std::vector<std::size_t>& scans) {
  std::vector<MappedKeyframe> keyframes;
  for (const std::size_t scan : scans) keyframes.push_back({scan, poses[scan], false});
  return keyframes;
}

TEST(TrackAssembly, KeyframesInTheirTrackedPlacesLeaveTheTrack) {
  const std::vector<Pose2> tracked = curve();
  for (const auto& scans : {std::vector<std::size_t>{}, {30}, {0, 20, 59}, {7, 20, 50}}) {
    const auto assembled = assemble_track(tracked, keyframes_of(tracked, scans));
    ASSERT_EQ(assembled.size(), tracked.size());
    for (std::size_t i = 0; i < tracked.size(); ++i) {
      EXPECT_THAT(assembled[i], PoseNear(tracked[i], PoseTolerance{}));
    }
  }
}

TEST(TrackAssembly, ARigidMotionOfTheKeyframesMovesAllScans) {
  const std::vector<Pose2> tracked = curve();
  const Pose2 T_map_odom{3.0, -2.0, 0.7};
  std::vector<MappedKeyframe> keyframes = keyframes_of(tracked, {5, 30, 50});
  for (MappedKeyframe& keyframe : keyframes) {
    keyframe.T_map_sensor = T_map_odom * keyframe.T_map_sensor;
  }
  const std::vector<Pose2> assembled = assemble_track(tracked, keyframes);
  for (std::size_t i = 0; i < tracked.size(); ++i) {
    EXPECT_THAT(assembled[i], PoseNear(T_map_odom * tracked[i], PoseTolerance{}));
  }
}

TEST(TrackAssembly, PassesThroughEveryKeyframeAndSlidesInBetween) {
  // A straight way, tracked too short by a fifth.
  std::vector<Pose2> tracked(41);
  std::vector<MappedKeyframe> keyframes;
  for (std::size_t i = 0; i < tracked.size(); ++i) {
    tracked[i].x_m = 0.08 * static_cast<double>(i);
    if (i % 10 == 0) keyframes.push_back({i, {0.1 * static_cast<double>(i), 0.0, 0.0}, false});
  }
  const std::vector<Pose2> assembled = assemble_track(tracked, keyframes);
  for (std::size_t i = 0; i < tracked.size(); ++i) {
    EXPECT_THAT(assembled[i],
                PoseNear(Pose2{0.1 * static_cast<double>(i), 0.0, 0.0}, PoseTolerance{}));
  }
}

/// A robot that stands and then turns, by 10 deg in one scan: tracking saw 12.
TEST(TrackAssembly, WhatTrackingIsOffByLiesWhereTheRobotMoved) {
  std::vector<Pose2> tracked(12);
  tracked.back().theta_rad = rad_from_deg(12.0);
  const std::vector<Pose2> assembled = assemble_track(
      tracked,
      std::vector<MappedKeyframe>{{0, {}, false}, {11, {0.0, 0.0, rad_from_deg(10.0)}, false}});
  for (std::size_t i = 0; i < 11; ++i)
    EXPECT_THAT(assembled[i], PoseNear(Pose2{}, PoseTolerance{}));
  EXPECT_NEAR(assembled.back().theta_rad, rad_from_deg(10.0), 1e-12);
}

TEST(TrackAssembly, WhereAPieceBeginsNothingSlides) {
  const std::vector<Pose2> tracked = curve();
  std::vector<MappedKeyframe> keyframes = keyframes_of(tracked, {0, 30, 50});
  const Pose2 elsewhere{7.0, 3.0, 1.0};
  for (const std::size_t k : {1, 2}) keyframes[k].T_map_sensor = elsewhere * tracked[k * 20 + 10];
  keyframes[1].begins_piece = true;
  const std::vector<Pose2> assembled = assemble_track(tracked, keyframes);
  for (std::size_t i = 0; i < tracked.size(); ++i) {
    const Pose2 expected = i < 30 ? tracked[i] : elsewhere * tracked[i];
    EXPECT_THAT(assembled[i], PoseNear(expected, PoseTolerance{})) << i;
  }
}

TEST(TrackAssembly, HeadingsSlideTheShortWay) {
  const std::vector<Pose2> tracked(11);
  const std::vector<Pose2> assembled = assemble_track(
      tracked, std::vector<MappedKeyframe>{{0, {0, 0, 3.1}, false}, {10, {0, 0, -3.1}, false}});
  EXPECT_NEAR(std::abs(wrap_to_pi(assembled[5].theta_rad - kPi)), 0.0, 1e-9);
}

TEST(TrackAssembly, NothingInNothingOut) { EXPECT_TRUE(assemble_track({}, {}).empty()); }

}  // namespace setsquare::track_assembly_test
