// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/sensing/ray_casting.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <thread>
#include <vector>

#include "setsquare/core/error.hpp"
#include "tests/sim/plans.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::testing::ray_casting_test {

Eigen::Vector2d random_direction(std::mt19937_64& generator) {
  const double lot = uniform(generator, 0.0, 1.0);
  if (lot < 0.1) return {1.0, 0.0};
  if (lot < 0.2) return {-1.0, 0.0};
  if (lot < 0.3) return {0.0, 1.0};
  if (lot < 0.4) return {0.0, -1.0};
  return unit_vector(uniform(generator, -kPi, kPi));
}

/// Within 1e-6 of the ends of a segment, rounding decides whether a ray meets it.
bool is_at_an_end(const FloorPlan& plan, const Eigen::Vector2d& p_m) {
  for (const PlanSegment& segment : plan.segments) {
    if ((segment.start_m - p_m).norm() < 1e-6 || (segment.end_m - p_m).norm() < 1e-6) return true;
  }
  return false;
}

/// Returns whether the ray hit anything.
bool expect_same_cast(const RayCaster& caster,
                      const Eigen::Vector2d& origin_m,
                      const Eigen::Vector2d& direction,
                      double max_range_m,
                      double from_m) {
  const auto hit = caster.cast(origin_m, direction, max_range_m, from_m);
  const auto twin = cast_at_every_segment(caster.plan(), origin_m, direction, max_range_m, from_m);
  for (const auto& either : {hit, twin}) {
    if (!either) continue;
    // So near to where it begins, rounding decides on which side of it a ray begins.
    if (either->range_m - from_m < 1e-7) return true;
    if (is_at_an_end(caster.plan(), origin_m + either->range_m * direction)) return true;
  }
  EXPECT_EQ(hit.has_value(), twin.has_value())
      << "from " << origin_m.transpose() << " along " << direction.transpose();
  if (!hit || !twin) return false;
  EXPECT_NEAR(hit->range_m, twin->range_m, 1e-7 * (1.0 + origin_m.norm()));
  if (hit->segment == twin->segment) {
    EXPECT_NEAR(hit->incidence_cos, twin->incidence_cos, 1e-9);
  }
  return true;
}

TEST(RayCasterTest, FindsWhatTryingEverySegmentFinds) {
  auto generator = make_generator();
  int num_hits = 0;
  int num_rays = 0;
  for (int plan = 0; plan < 60; ++plan) {
    const double side_m = std::pow(10.0, uniform(generator, -1.0, 2.5));
    const Eigen::Vector2d middle_m = (plan % 3 == 0 ? 1e5 : 10.0) * random_direction(generator);
    const int num_segments = static_cast<int>(uniform(generator, 1.0, 80.0));
    const RayCaster caster(random_plan(generator, num_segments, side_m, middle_m));
    for (int ray = 0; ray < 300; ++ray) {
      // Every fourth from far outside the plan, every fifth from round coordinates.
      const double reach_m = (ray % 4 == 0 ? 5.0 : 0.6) * side_m;
      Eigen::Vector2d origin_m = middle_m + reach_m * Eigen::Vector2d(uniform(generator, -1, 1),
                                                                      uniform(generator, -1, 1));
      if (ray % 5 == 0) origin_m = origin_m.array().round();
      const double max_range_m = (ray % 3 == 0 ? 0.3 : 100.0) * side_m;
      const double from_m = ray % 2 == 0 ? 0.0 : uniform(generator, 0.0, side_m);
      num_hits +=
          expect_same_cast(caster, origin_m, random_direction(generator), max_range_m, from_m);
      ++num_rays;
    }
  }
  EXPECT_GT(num_hits, num_rays / 4);
  EXPECT_LT(num_hits, num_rays * 9 / 10);
}

TEST(RayCasterTest, CastIsInvariantUnderRigidMotionOfPlanAndRay) {
  auto generator = make_generator();
  for (int trial = 0; trial < 40; ++trial) {
    const FloorPlan plan = random_plan(generator, 40, 20.0);
    const RayCaster caster(plan);
    const Pose2 T_new_old{uniform(generator, -500, 500),
                          uniform(generator, -500, 500),
                          uniform(generator, -kPi, kPi)};
    const RayCaster moved_caster(moved(T_new_old, plan));
    for (int ray = 0; ray < 50; ++ray) {
      const Eigen::Vector2d origin_m(uniform(generator, -10, 10), uniform(generator, -10, 10));
      const double angle_rad = uniform(generator, -kPi, kPi);
      const auto hit = caster.cast(origin_m, unit_vector(angle_rad), 25.0);
      const auto moved_hit = moved_caster.cast(
          T_new_old * origin_m, unit_vector(angle_rad + T_new_old.theta_rad), 25.0);
      ASSERT_EQ(hit.has_value(), moved_hit.has_value());
      if (!hit) continue;
      EXPECT_NEAR(hit->range_m, moved_hit->range_m, 1e-9);
      EXPECT_NEAR(hit->incidence_cos, moved_hit->incidence_cos, 1e-9);
    }
  }
}

TEST(RayCasterTest, ARoomHasNoGapsEvenAtItsCorners) {
  auto generator = make_generator();
  for (int trial = 0; trial < 50; ++trial) {
    const Pose2 T_new_old{uniform(generator, -50, 50), 0.1, uniform(generator, -kPi, kPi)};
    const FloorPlan room = moved(T_new_old, polygon_plan(3 + trial, 4.0));
    const RayCaster caster(room);
    for (int ray = 0; ray < 200; ++ray) {
      const Eigen::Vector2d origin_m =
          T_new_old * Eigen::Vector2d(uniform(generator, -1, 1), uniform(generator, -1, 1));
      const PlanSegment& wall = room.segments[ray % room.segments.size()];
      const Eigen::Vector2d direction = (wall.start_m - origin_m).normalized();
      EXPECT_TRUE(caster.cast(origin_m, direction, 100.0)) << "aimed at a corner";
    }
  }
}

TEST(RayCasterTest, GoesOnBehindAHit) {
  FloorPlan plan;
  for (int i = 1; i <= 5; ++i) plan.segments.push_back({{1.0 * i, -1.0}, {1.0 * i, 1.0}});
  const RayCaster caster(plan);
  double from_m = 0.0;
  for (std::uint32_t i = 0; i < 5; ++i) {
    const auto hit = caster.cast({0.0, 0.0}, {1.0, 0.0}, 100.0, from_m);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->segment, i);
    EXPECT_DOUBLE_EQ(hit->range_m, 1.0 + i);
    from_m = hit->range_m;
  }
  EXPECT_FALSE(caster.cast({0.0, 0.0}, {1.0, 0.0}, 100.0, from_m));
  EXPECT_TRUE(caster.cast({0.0, 0.0}, {1.0, 0.0}, 1.0)) << "the reach belongs to it";
  EXPECT_FALSE(caster.cast({0.0, 0.0}, {1.0, 0.0}, 0.999));
}

TEST(RayCasterTest, IncidenceIsTheCosineToTheNormal) {
  const RayCaster caster(rectangle_plan(10.0, 10.0));
  EXPECT_NEAR(caster.cast({5.0, 5.0}, {1.0, 0.0}, 30.0)->incidence_cos, 1.0, 1e-12);
  EXPECT_NEAR(
      caster.cast({5.0, 1.0}, unit_vector(-0.5), 30.0)->incidence_cos, std::sin(0.5), 1e-12);
}

TEST(RayCasterTest, AnEmptyPlanAndPointsAreNotHit) {
  EXPECT_FALSE(RayCaster(FloorPlan{}).cast({0, 0}, {1, 0}, 30.0));
  FloorPlan point;
  point.segments.push_back({{1.0, 0.0}, {1.0, 0.0}});
  EXPECT_FALSE(RayCaster(point).cast({0, 0}, {1, 0}, 30.0));
  FloorPlan edge_on;
  edge_on.segments.push_back({{1.0, 0.0}, {2.0, 0.0}});
  EXPECT_FALSE(RayCaster(edge_on).cast({0, 0}, {1, 0}, 30.0));
}

TEST(RayCasterTest, AWidePlanCostsNoMoreMemoryThanItMay) {
  FloorPlan plan = rectangle_plan(10.0, 10.0);
  plan.segments.push_back({{1e7, -3e6}, {1e7, -3e6 + 1.0}});
  plan.segments.push_back({{0.0, 1e8}, {1.0, 1e8}});
  EXPECT_LT(SegmentGrid(plan).num_cells(), std::size_t{5'000'000});
  const RayCaster caster(plan);
  EXPECT_NEAR(caster.cast({5.0, 5.0}, {0.0, 1.0}, 30.0)->range_m, 5.0, 1e-9);

  FloorPlan far_away = moved({7e5, -4e5, 0.0}, rectangle_plan(10.0, 10.0));
  EXPECT_LT(SegmentGrid(far_away).num_cells(), std::size_t{1000});
  plan.segments[0].start_m.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(RayCaster{plan}, ParameterError);
}

TEST(RayCasterTest, TwoThreadsCastAtOnce) {
  auto generator = make_generator();
  const RayCaster caster(random_plan(generator, 300, 30.0));
  const auto cast_around = [&](std::vector<double>& ranges_m) {
    for (int i = 0; i < 20000; ++i) {
      const auto hit = caster.cast({0.3, 0.2}, unit_vector(1e-3 * i), 30.0);
      ranges_m.push_back(hit ? hit->range_m : -1.0);
    }
  };
  std::vector<double> alone_m;
  std::vector<double> first_m;
  std::vector<double> second_m;
  cast_around(alone_m);
  std::thread first(cast_around, std::ref(first_m));
  std::thread second(cast_around, std::ref(second_m));
  first.join();
  second.join();
  EXPECT_EQ(first_m, alone_m);
  EXPECT_EQ(second_m, alone_m);
}

}  // namespace setsquare::testing::ray_casting_test
