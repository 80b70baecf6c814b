// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/slam/submap_alignment.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "setsquare/slam/submap_refinement.hpp"
#include "tests/slam/simulated_drive.hpp"
#include "tests/support/pose_matchers.hpp"

namespace setsquare {
namespace {

using testing::l_shaped_room;
using testing::PoseNear;
using testing::PoseTolerance;
using testing::scan_of_walls;

Keyframe keyframe_at(const Pose2& T_odom_sensor, const Scan& scan) {
  const SurfacePoints points = surface_points_from_scan(scan);
  return {.scan_index = 0,
          .T_odom_sensor = T_odom_sensor,
          .image = SurfaceImage(scan, points),
          .scan = scan};
}

class SubmapAlignmentTest : public ::testing::Test {
 protected:
  SubmapAlignmentTest() {
    for (const Pose2& pose : {Pose2{1.0, 1.0, 0.3}, Pose2{1.3, 1.1, 0.4}}) {
      submap_.push_back(keyframe_at(pose, scan_of_walls(l_shaped_room(), pose)));
    }
  }
  std::vector<Keyframe> submap_;
  PointMarks marks_;
};

TEST_F(SubmapAlignmentTest, AScanInItsPlaceIsExplainedAndAtRest) {
  const Pose2 pose{1.15, 1.05, 0.35};
  const SurfacePoints points = surface_points_from_scan(scan_of_walls(l_shaped_room(), pose));
  const SubmapAlignment alignment = align_with_submap(submap_, points, pose, {}, marks_);
  EXPECT_GT(alignment.explained(), 0.95);
  EXPECT_EQ(alignment.num_contradicted, 0.0);
  EXPECT_LT(alignment.gradient.norm() / alignment.hessian.norm(), 1e-3);
  EXPECT_GT(closeness_to_submap(submap_, points, pose, 0.05), 0.9);
}

TEST_F(SubmapAlignmentTest, AScanInAWrongPlaceIsContradicted) {
  const Pose2 pose{1.15, 1.05, 0.35};
  const SurfacePoints points = surface_points_from_scan(scan_of_walls(l_shaped_room(), pose));
  const Pose2 wrong{1.15, 1.05, 0.35 + 0.5 * kPi};
  EXPECT_LT(align_with_submap(submap_, points, wrong, {}, marks_).score(), 0.2);
}

TEST_F(SubmapAlignmentTest, APointCountsOnceHoweverOftenItWasSeen) {
  const Pose2 pose{1.15, 1.05, 0.35};
  const SurfacePoints points = surface_points_from_scan(scan_of_walls(l_shaped_room(), pose));
  const auto once = align_with_submap(submap_, points, pose, {}, marks_);
  std::vector<Keyframe> twice = submap_;
  twice.insert(twice.end(), submap_.begin(), submap_.end());
  const auto again = align_with_submap(twice, points, pose, {}, marks_);
  EXPECT_EQ(again.num_explained, once.num_explained);
  EXPECT_TRUE(again.hessian.isApprox(once.hessian, 1e-9));
}

TEST_F(SubmapAlignmentTest, RefinementFindsThePlaceFromAside) {
  const Pose2 pose{1.15, 1.05, 0.35};
  const SurfacePoints points = surface_points_from_scan(scan_of_walls(l_shaped_room(), pose));
  for (const Pose2& off : {Pose2{0.15, 0.0, 0.0}, Pose2{-0.1, 0.1, 0.05}, Pose2{0.0, -0.1, -0.1}}) {
    const Pose2 start = pose * off;
    const SubmapFit fit = refine_in_submap({submap_, points, start, {}, marks_}, start, {});
    EXPECT_THAT(fit.T_odom_sensor,
                PoseNear(pose, PoseTolerance{.translation_m = 0.003, .rotation_rad = 0.001}));
    EXPECT_GT(fit.weak.effective_points, 3.0);
  }
}

}  // namespace
}  // namespace setsquare
