// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/slam/track_assembly.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/support/pose_matchers.hpp"

namespace setsquare {
namespace {

using testing::PoseNear;
using testing::PoseTolerance;

/// A curve as tracked, beginning at the origin.
std::vector<Pose2> curve() {
  std::vector<Pose2> poses{{}};
  for (int i = 1; i < 60; ++i) poses.push_back(poses.back() * Pose2{0.1, 0.002, 0.03});
  return poses;
}

TEST(TrackAssembly, WithoutDriftTheTrackStays) {
  const std::vector<Pose2> tracked = curve();
  const std::vector<DriftAtScan> drifts{{0, 0.0}, {20, 0.0}, {50, 0.0}};
  for (const auto& assembled : {assemble_track(tracked, {}), assemble_track(tracked, drifts)}) {
    ASSERT_EQ(assembled.size(), tracked.size());
    for (std::size_t i = 0; i < tracked.size(); ++i) {
      EXPECT_THAT(assembled[i], PoseNear(tracked[i], PoseTolerance{}));
    }
  }
}

TEST(TrackAssembly, AConstantDriftTurnsTheWholeTrack) {
  const std::vector<Pose2> tracked = curve();
  const std::vector<DriftAtScan> drifts{{0, 0.7}, {30, 0.7}};
  const std::vector<Pose2> assembled = assemble_track(tracked, drifts);
  for (std::size_t i = 0; i < tracked.size(); ++i) {
    EXPECT_THAT(assembled[i], PoseNear(Pose2{0.0, 0.0, 0.7} * tracked[i], PoseTolerance{}));
  }
}

TEST(TrackAssembly, UndoesADriftThatGrows) {
  // A straight way, tracked as an arc because the heading drifted by 0.01 rad a scan.
  constexpr std::size_t kNumScans = 41;
  std::vector<Pose2> tracked(kNumScans);
  std::vector<DriftAtScan> drifts;
  for (std::size_t i = 0; i < kNumScans; ++i) {
    const double heading_rad = 0.01 * static_cast<double>(i);
    tracked[i].theta_rad = heading_rad;
    if (i > 0) {
      const double chord_rad = heading_rad - 0.005;
      tracked[i].x_m = tracked[i - 1].x_m + 0.1 * std::cos(chord_rad);
      tracked[i].y_m = tracked[i - 1].y_m + 0.1 * std::sin(chord_rad);
    }
    if (i % 10 == 0) drifts.push_back({i, -heading_rad});
  }
  const std::vector<Pose2> assembled = assemble_track(tracked, drifts);
  for (std::size_t i = 0; i < kNumScans; ++i) {
    EXPECT_THAT(assembled[i],
                PoseNear(Pose2{0.1 * static_cast<double>(i), 0.0, 0.0}, PoseTolerance{}));
  }
}

TEST(TrackAssembly, NothingInNothingOut) { EXPECT_TRUE(assemble_track({}, {}).empty()); }

}  // namespace
}  // namespace setsquare
