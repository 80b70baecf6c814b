// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/pairs/pair_geometry.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <Eigen/LU>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/symmetric_eigen.hpp"
#include "tests/sim/plans.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::testing::pair_geometry_test {

double distance_to_piece_m(const SurfacePiece& piece, const Eigen::Vector2d& p_m) {
  const Eigen::Vector2d way = piece.end_m - piece.start_m;
  if (way.norm() < 1e-9) return (p_m - piece.start_m).norm();
  const Eigen::Vector2d along = way.normalized();
  const double at_m = along.dot(p_m - piece.start_m);
  if (at_m < 0.0) return (p_m - piece.start_m).norm();
  if (at_m > way.norm()) return (p_m - piece.end_m).norm();
  return std::abs(along.x() * (p_m - piece.start_m).y() - along.y() * (p_m - piece.start_m).x());
}

/// The plain twin: every piece is tried; 3x3 sums; Schur complements by inverses.
PairGeometry plain_pair_geometry(const VisibleSurface& reference, const VisibleSurface& current) {
  std::vector<SurfaceReturn> common;
  Eigen::Vector2d centroid_m(0.0, 0.0);
  double length_m = 0.0;
  for (const SurfaceReturn& seen : current.returns) {
    if (std::any_of(reference.pieces.begin(), reference.pieces.end(), [&](const auto& piece) {
          return distance_to_piece_m(piece, seen.p_m) <= 0.2;
        })) {
      common.push_back(seen);
      centroid_m += seen.length_m * seen.p_m;
      length_m += seen.length_m;
    }
  }
  PairGeometry geometry;
  geometry.overlap =
      static_cast<double>(common.size()) / static_cast<double>(current.returns.size());
  if (common.empty()) return geometry;
  centroid_m /= length_m;
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (const SurfaceReturn& seen : common) {
    const Eigen::Vector2d r = seen.p_m - centroid_m;
    const Eigen::Vector3d row(
        seen.normal.x(), seen.normal.y(), r.x() * seen.normal.y() - r.y() * seen.normal.x());
    information += seen.length_m * row * row.transpose();
  }
  const Eigen::Matrix3d covariance = information.inverse();
  geometry.wall_turning_m3 = 1.0 / covariance(2, 2);
  const Eigen::Matrix2d translation = covariance.topLeftCorner<2, 2>().inverse();
  const SymmetricEigen<2> axes = symmetric_eigen(translation);
  geometry.wall_across_m = axes.values(0);
  geometry.worst_direction_rad = std::atan2(axes.vectors(1, 0), axes.vectors(0, 0));
  return geometry;
}

Pose2 random_pose(std::mt19937_64& generator, double reach_m) {
  return {uniform(generator, -reach_m, reach_m),
          uniform(generator, -reach_m, reach_m),
          uniform(generator, -kPi, kPi)};
}

TEST(PairGeometryTest, IsWhatThePlainTwinFinds) {
  auto generator = make_generator();
  int num_compared = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const RayCaster caster(random_plan(generator, 15, 20.0));
    const ScannerModel scanner = trial % 2 == 0 ? with_num_beams(utm_30lx(), 271) : low_cost_360();
    const Pose2 T_map_reference = random_pose(generator, 8.0);
    const Pose2 T_map_current = T_map_reference * random_pose(generator, 2.0);
    const VisibleSurface reference = visible_surface(caster, scanner, T_map_reference);
    const VisibleSurface current = visible_surface(caster, scanner, T_map_current);
    if (current.returns.empty()) continue;
    const PairGeometry geometry = pair_geometry(caster, scanner, T_map_reference, T_map_current);
    const PairGeometry plain = plain_pair_geometry(reference, current);
    EXPECT_DOUBLE_EQ(geometry.overlap, plain.overlap);
    if (!(plain.wall_across_m > 1e-3)) continue;
    ++num_compared;
    EXPECT_NEAR(geometry.wall_across_m, plain.wall_across_m, 1e-6);
    EXPECT_NEAR(geometry.wall_turning_m3, plain.wall_turning_m3, 1e-6);
    const double turned_rad = geometry.worst_direction_rad - plain.worst_direction_rad;
    EXPECT_NEAR(wrap_to_period(turned_rad, kPi), 0.0, 1e-3);
  }
  EXPECT_GT(num_compared, 30);
}

TEST(PairGeometryTest, AScanOverlapsItselfAndNotTheNextRoom) {
  auto generator = make_generator();
  for (int trial = 0; trial < 20; ++trial) {
    const RayCaster caster(random_plan(generator, 60, 20.0));
    const Pose2 pose = random_pose(generator, 8.0);
    EXPECT_EQ(pair_geometry(caster, utm_30lx(), pose, pose).overlap, 1.0);
  }
  FloorPlan rooms = rectangle_plan(5.0, 5.0);
  const FloorPlan next = moved({5.5, 0.0, 0.0}, rooms);
  rooms.segments.insert(rooms.segments.end(), next.segments.begin(), next.segments.end());
  const PairGeometry apart =
      pair_geometry(RayCaster(rooms), utm_30lx(), {2.5, 2.5, 0.0}, {8.0, 2.5, 0.0});
  EXPECT_EQ(apart.overlap, 0.0);
  EXPECT_FALSE(apart.is_determined());
}

TEST(PairGeometryTest, OverlapIsTheShareThatTheReferenceSaw) {
  // A dividing wall hides the far half of one long wall from the reference.
  FloorPlan plan;
  plan.segments.push_back({{-10.0, 3.0}, {10.0, 3.0}});
  plan.segments.push_back({{0.0, 0.5}, {0.0, 3.0}});
  const RayCaster caster(plan);
  const ScannerModel scanner = with_field_of_view(utm_30lx(), kTwoPi);
  const VisibleSurface reference = visible_surface(caster, scanner, {-2.0, 1.0, 0.0});
  const VisibleSurface current = visible_surface(caster, scanner, {2.0, 1.0, 0.0});
  // Common: the dividing wall, seen from either side, and what lies within 0.2 m of its foot.
  int num_divider = 0;
  for (const SurfaceReturn& seen : current.returns) num_divider += seen.p_m.x() <= 0.2;
  EXPECT_NEAR(pair_geometry(reference, current).overlap,
              num_divider / static_cast<double>(current.returns.size()),
              0.003);
}

TEST(PairGeometryTest, ABareCorridorHasNoWallAcross) {
  for (const double angle_rad : {0.0, 0.3, 1.2, -1.0}) {
    const Pose2 T_new_old{3.0, -2.0, angle_rad};
    const RayCaster caster(moved(T_new_old, corridor_plan()));
    const PairGeometry geometry = pair_geometry(
        caster, utm_30lx(), T_new_old * Pose2{0.0, 0.3, 0.1}, T_new_old * Pose2{2.0, 0.0, 0.0});
    EXPECT_NEAR(geometry.wall_across_m, 0.0, 1e-6);
    EXPECT_NEAR(wrap_to_period(geometry.worst_direction_rad - angle_rad, kPi), 0.0, 1e-6);
    EXPECT_GT(geometry.wall_turning_m3, 100.0);
    EXPECT_FALSE(geometry.is_determined());
  }
}

TEST(PairGeometryTest, ARoomIsDetermined) {
  const ScannerModel all_around = with_field_of_view(utm_30lx(), kTwoPi);
  const PairGeometry geometry = pair_geometry(
      RayCaster(rectangle_plan(6.0, 4.0)), all_around, {3.0, 2.0, 0.0}, {2.0, 2.5, 2.0});
  EXPECT_NEAR(geometry.wall_across_m, 8.0, 0.2) << "the short walls stand across the worst";
  EXPECT_NEAR(wrap_to_period(geometry.worst_direction_rad, kPi), 0.0, 0.02);
  EXPECT_TRUE(geometry.is_determined());
}

TEST(PairGeometryTest, ARoundHallDoesNotDetermineRotationHoweverManySides) {
  for (const int num_corners : {20, 36, 64, 300}) {
    const RayCaster caster(polygon_plan(num_corners, 4.0));
    const ScannerModel scanner = with_field_of_view(utm_30lx(), kTwoPi);
    const PairGeometry geometry = pair_geometry(caster, scanner, {0, 0, 0.5}, {0.5, 0.2, -1.0});
    EXPECT_LT(geometry.wall_turning_m3, 0.01) << num_corners;
    EXPECT_FALSE(geometry.is_determined());
    EXPECT_EQ(geometry.overlap, 1.0);
  }
  // Eight sides are walls.
  EXPECT_GT(pair_geometry(RayCaster(polygon_plan(8, 4.0)), utm_30lx(), {}, {}).wall_turning_m3,
            3.0);
}

TEST(PairGeometryTest, DoesNotDependOnTheMapsFrame) {
  auto generator = make_generator();
  const FloorPlan plan = random_plan(generator, 60, 20.0);
  for (int trial = 0; trial < 10; ++trial) {
    const Pose2 T_new_old = random_pose(generator, 300.0);
    const Pose2 reference = random_pose(generator, 5.0);
    const Pose2 current = reference * Pose2{0.5, 0.2, 0.3};
    const PairGeometry old = pair_geometry(RayCaster(plan), utm_30lx(), reference, current);
    const PairGeometry now = pair_geometry(
        RayCaster(moved(T_new_old, plan)), utm_30lx(), T_new_old * reference, T_new_old * current);
    EXPECT_NEAR(now.overlap, old.overlap, 0.002);
    EXPECT_NEAR(now.wall_across_m, old.wall_across_m, 0.01 * old.wall_across_m + 1e-6);
    EXPECT_NEAR(now.wall_turning_m3, old.wall_turning_m3, 0.01 * old.wall_turning_m3 + 1e-6);
  }
}

TEST(PairGeometryTest, GlassIsNoWall) {
  FloorPlan plan = rectangle_plan(6.0, 4.0);
  for (PlanSegment& segment : plan.segments) segment.material = Material::kGlass;
  EXPECT_TRUE(visible_surface(RayCaster(plan), utm_30lx(), {3.0, 2.0, 0.0}).returns.empty());
  EXPECT_EQ(pair_geometry(RayCaster(plan), utm_30lx(), {3, 2, 0}, {3, 2, 0}).overlap, 0.0);
}

TEST(VisibleSurfaceTest, ARoomIsOneChainOfItsWalls) {
  const RayCaster caster(rectangle_plan(6.0, 4.0));
  const ScannerModel all_around = with_field_of_view(utm_30lx(), kTwoPi);
  const VisibleSurface surface = visible_surface(caster, all_around, {2.0, 1.0, 0.3});
  EXPECT_EQ(surface.returns.size(), all_around.num_beams);
  double pieces_m = 0.0;
  for (const SurfacePiece& piece : surface.pieces) {
    pieces_m += (piece.end_m - piece.start_m).norm();
  }
  EXPECT_NEAR(pieces_m, 20.0, 1e-9) << "every corner found, the last beam joined to the first";
  double returns_m = 0.0;
  for (const SurfaceReturn& seen : surface.returns) returns_m += seen.length_m;
  EXPECT_NEAR(returns_m, 20.0, 0.1);
}

}  // namespace setsquare::testing::pair_geometry_test
