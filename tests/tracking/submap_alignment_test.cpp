// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/submap_alignment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "setsquare/tracking/submap_refinement.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/simulated_drive.hpp"

namespace setsquare::submap_alignment_test {

using testing::l_shaped_room;
using testing::PoseNear;
using testing::PoseTolerance;
using testing::scan_of_walls;

SurfaceImage image_of(const Scan& scan) {
  return SurfaceImage(scan, surface_points_from_scan(scan));
}

/// Every return of a scan.
SurfaceSamples points_of(const Scan& scan) {
  const SurfacePoints points = surface_points_from_scan(scan);
  return sample_surface(points, points.size());
}

class SubmapAlignmentTest : public ::testing::Test {
 protected:
  SubmapAlignmentTest() {
    const std::vector<Pose2> poses = {{1.0, 1.0, 0.3}, {1.3, 1.1, 0.4}};
    for (const Pose2& pose : poses) images_.push_back(image_of(scan_of_walls(room_, pose)));
    for (std::size_t i = 0; i < poses.size(); ++i) submap_.push_back({&images_[i], poses[i]});
  }
  const std::vector<testing::Wall> room_ = l_shaped_room();
  std::vector<SurfaceImage> images_;
  std::vector<PlacedImage> submap_;
  PointMarks marks_;
};

TEST_F(SubmapAlignmentTest, AScanInItsPlaceIsExplainedAndAtRest) {
  const Pose2 pose{1.15, 1.05, 0.35};
  const SurfaceSamples points = points_of(scan_of_walls(room_, pose));
  const SubmapAlignment alignment = align_with_submap(submap_, points, pose, {}, marks_);
  EXPECT_GT(alignment.score(), 0.95);
  EXPECT_EQ(alignment.num_contradicted, 0.0);
  EXPECT_LT(alignment.gradient.norm() / alignment.hessian.norm(), 1e-3);
  EXPECT_GT(closeness_to_submap(submap_, points, pose, 0.05), 0.9);
}

TEST_F(SubmapAlignmentTest, AScanInAWrongPlaceIsContradicted) {
  const Pose2 pose{1.15, 1.05, 0.35};
  const SurfaceSamples points = points_of(scan_of_walls(room_, pose));
  const Pose2 wrong{1.15, 1.05, 0.35 + 0.5 * kPi};
  EXPECT_LT(align_with_submap(submap_, points, wrong, {}, marks_).score(), 0.2);
}

TEST_F(SubmapAlignmentTest, APointCountsOnceHoweverOftenItWasSeen) {
  const Pose2 pose{1.15, 1.05, 0.35};
  const SurfaceSamples points = points_of(scan_of_walls(room_, pose));
  const auto once = align_with_submap(submap_, points, pose, {}, marks_);
  std::vector<PlacedImage> twice = submap_;
  twice.insert(twice.end(), submap_.begin(), submap_.end());
  const auto again = align_with_submap(twice, points, pose, {}, marks_);
  EXPECT_EQ(again.num_explained, once.num_explained);
  EXPECT_TRUE(again.hessian.isApprox(once.hessian, 1e-9));
}

/// The normal equations of one keyframe at the origin, plainly: in double precision, as written.
Eigen::Matrix<double, 3, 4> plain_equations(const SurfaceImage& image,
                                            const SurfaceSamples& points,
                                            const Pose2& T,
                                            const AlignmentScale& scale) {
  Eigen::Matrix<double, 3, 4> sums = Eigen::Matrix<double, 3, 4>::Zero();
  const Pose2 turn{0.0, 0.0, T.theta_rad};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d arm = turn * Eigen::Vector2d(points.x_m[i], points.y_m[i]);
    const Eigen::Vector2d p = arm + T.translation();
    const auto x_m = static_cast<float>(p.x());
    const auto y_m = static_cast<float>(p.y());
    const SurfaceSector& sector = image.at(x_m, y_m);
    if (sector.offset_m == SurfaceImage::kNoSurface_m) continue;
    const double distance_m = SurfaceImage::signed_distance_m(sector, x_m, y_m);
    const Eigen::Vector2d n(sector.normal_x, sector.normal_y);
    const Eigen::Vector2d normal = turn * Eigen::Vector2d(points.normal_x[i], points.normal_y[i]);
    if (normal.dot(n) <= 0.7 || std::abs(distance_m) > scale.gate_m) continue;
    const double weight = std::pow(1.0 + std::pow(distance_m / scale.scale_m, 2), -2);
    const Eigen::Vector3d row(n.x(), n.y(), n.y() * arm.x() - n.x() * arm.y());
    sums.leftCols<3>() += weight * row * row.transpose();
    sums.col(3) += weight * distance_m * row;
  }
  return sums;
}

TEST_F(SubmapAlignmentTest, TheNormalEquationsAreThoseOfThePlainSums) {
  const Pose2 pose{1.15, 1.05, 0.35};
  const SurfaceImage image = image_of(scan_of_walls(room_, pose));
  const PlacedImage placed{&image, {}};
  const SurfaceSamples points = points_of(scan_of_walls(room_, pose));
  const AlignmentScale scale{.gate_m = 0.15, .scale_m = 0.05};
  for (const Pose2& off : {Pose2{0.02, -0.03, 0.01}, Pose2{0.08, 0.05, -0.03}}) {
    const auto plain = plain_equations(image, points, off, scale);
    const auto found = align_with_submap({&placed, 1}, points, off, scale, marks_);
    EXPECT_LT((found.hessian - plain.leftCols<3>()).norm(), 1e-3 * plain.leftCols<3>().norm());
    EXPECT_LT((found.gradient - plain.col(3)).norm(), 1e-3 * plain.col(3).norm());
  }
}

TEST_F(SubmapAlignmentTest, RefinementFindsThePlaceFromAside) {
  const Pose2 pose{1.15, 1.05, 0.35};
  const SurfaceSamples points = points_of(scan_of_walls(room_, pose));
  for (const Pose2& off : {Pose2{0.15, 0.0, 0.0}, Pose2{-0.1, 0.1, 0.05}, Pose2{0.0, -0.1, -0.1}}) {
    const Pose2 start = pose * off;
    const SubmapFit fit = refine_in_submap({submap_, points, start, {}, marks_}, start, {});
    EXPECT_THAT(fit.T_odom_sensor,
                PoseNear(pose, PoseTolerance{.translation_m = 0.003, .rotation_rad = 0.001}));
    EXPECT_GT(fit.open.effective_points, 3.0);
  }
}

}  // namespace setsquare::submap_alignment_test
