// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/Core>

#include "setsquare/core/angle.hpp"
#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/pairs/pair_geometry.hpp"
#include "setsquare/sim/sensing/robot_path.hpp"
#include "tests/sim/clearance.hpp"

namespace setsquare::paper_building_test {

constexpr double kSpacing_m = 0.4;
constexpr double kSpacing_rad = rad_from_deg(10.0);

/// Length of the way that the robot drives up to a distance along the route.
double driven_m(const RobotPath& path, double s_m) {
  constexpr double kStep_s = 0.02;
  const double end = path.time_at_route_distance(s_m);
  double length = 0.0;
  for (double time = 0.0; time < end; time += kStep_s)
    length +=
        (path.pose_at(time + kStep_s).translation() - path.pose_at(time).translation()).norm();
  return length;
}

TEST(PaperBuildingTest, HasTheExtentsOfThePaper) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const PaperBuilding paper = make_paper_building(seed);
    Eigen::Array2d low(0.0, 0.0), high(0.0, 0.0);
    for (const PlanSegment& segment : paper.building.plan.segments) {
      low = low.min(segment.start_m.array());
      high = high.max(segment.start_m.array());
    }
    EXPECT_NEAR(high.x() - low.x(), 236.0, 0.5);
    EXPECT_NEAR(high.y() - low.y(), 136.0, 0.5);
  }
}

TEST(PaperBuildingTest, TrackAndCircuitsHaveTheLengthsOfThePaper) {
  const PaperBuilding paper = make_paper_building(1);
  const RobotPath path(paper.building.route_m);
  EXPECT_NEAR(path.length_m(), 1124.0, 1.0);
  const auto& [first, second] = paper.circuits;
  EXPECT_NEAR(driven_m(path, first.end_s_m) - driven_m(path, first.start_s_m), 398.0, 0.5);
  EXPECT_NEAR(driven_m(path, second.end_s_m) - driven_m(path, second.start_s_m), 901.0, 0.5);
}

TEST(PaperBuildingTest, CircuitsBeginAndEndAtTheirPlaces) {
  const PaperBuilding paper = make_paper_building(1);
  const RobotPath path(paper.building.route_m);
  const auto distance_to = [&path](double s_m, double x_m, double y_m) {
    const Pose2 pose = path.pose_at(path.time_at_route_distance(s_m));
    return (pose.translation() - Eigen::Vector2d(x_m, y_m)).norm();
  };
  EXPECT_LT(distance_to(paper.circuits[0].start_s_m, 85.0, 33.0), 0.2);
  EXPECT_LT(distance_to(paper.circuits[0].end_s_m, 85.0, 33.0), 0.2);
  EXPECT_LT(distance_to(paper.circuits[1].start_s_m, 83.0, -19.0), 0.05);
  EXPECT_LT(distance_to(paper.circuits[1].end_s_m, 83.0, -19.0), 0.05);
  EXPECT_EQ(paper.building.route_m.front(), Eigen::Vector2d(0.0, 0.0));
}

TEST(PaperBuildingTest, TrackIsFreeAndHasAboutAsManyScansAsThePaper) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Building building = make_paper_building(seed).building;
    const RobotPath path(building.route_m);
    EXPECT_NEAR(
        static_cast<double>(sample_times(path, kSpacing_m, kSpacing_rad).size()), 2800.0, 120.0);
    for (double time = 0.0; time < path.duration_s(); time += 1.0)
      ASSERT_GE(clearance_m(building.plan, path.pose_at(time).translation()), 0.35) << time;
  }
}

TEST(PaperHallwayTest, NeighboursOverlapByHalfAndTheEndsByLittle) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Building hallway = make_paper_hallway(seed);
    const RobotPath path(hallway.route_m);
    const RayCaster caster(hallway.plan);
    const std::vector<double> times = sample_times(path, kSpacing_m, kSpacing_rad);
    ASSERT_GE(times.size(), 15U);
    const auto overlap = [&](std::size_t i, std::size_t j) {
      return pair_geometry(caster, utm_30lx(), path.pose_at(times[i]), path.pose_at(times[j]))
          .overlap;
    };
    for (std::size_t i = 1; i < 15; ++i) EXPECT_GT(overlap(i - 1, i), 0.5) << seed << ", " << i;
    EXPECT_LT(overlap(0, 14), 0.3) << seed;
    const double turn =
        wrap_to_pi(path.pose_at(times[14]).theta_rad - path.pose_at(times[0]).theta_rad);
    EXPECT_NEAR(turn, 0.5 * kPi, 0.05);
  }
}

}  // namespace setsquare::paper_building_test
