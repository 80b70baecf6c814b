// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/building/building.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "setsquare/sim/sensing/robot_path.hpp"
#include "tests/sim/clearance.hpp"

namespace setsquare::building_test {

constexpr double kRobotClearance_m = 0.35;

class BuildingTest : public testing::TestWithParam<BuildingClass> {};

INSTANTIATE_TEST_SUITE_P(AllClasses,
                         BuildingTest,
                         testing::ValuesIn(kAllBuildingClasses),
                         [](const auto& named) { return std::string(to_string(named.param)); });

TEST_P(BuildingTest, RouteKeepsClearOfEverythingFixed) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Building building = make_building(GetParam(), seed);
    for (std::size_t i = 1; i < building.route_m.size(); ++i)
      ASSERT_GE(clearance_m(building.plan, building.route_m[i - 1], building.route_m[i]),
                kRobotClearance_m)
          << "seed " << seed << ", piece " << i;
  }
}

TEST_P(BuildingTest, RobotThatRoundsTheCornersKeepsClear) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Building building = make_building(GetParam(), seed);
    const RobotPath path(building.route_m);
    EXPECT_GT(path.length_m(), 20.0) << "seed " << seed;
    EXPECT_LT(path.length_m(), 110.0) << "seed " << seed;
    for (double time = 0.0; time < path.duration_s(); time += 0.2)
      ASSERT_GE(clearance_m(building.plan, path.pose_at(time).translation()), 0.34)
          << "seed " << seed << " at " << time << " s";
  }
}

TEST_P(BuildingTest, PeopleStandAndWalkOnFreeFloor) {
  std::size_t num_people = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Building building = make_building(GetParam(), seed);
    num_people += building.people.size();
    for (const Person& person : building.people)
      ASSERT_GE(clearance_m(building.plan, person.from_m, person.to_m), 0.2) << "seed " << seed;
  }
  EXPECT_GT(num_people, 20U);
}

TEST_P(BuildingTest, SameSeedGivesTheSameBuilding) {
  const Building first = make_building(GetParam(), 7);
  const Building again = make_building(GetParam(), 7);
  const Building other = make_building(GetParam(), 8);
  EXPECT_EQ(first.route_m, again.route_m);
  ASSERT_EQ(first.plan.segments.size(), again.plan.segments.size());
  for (std::size_t i = 0; i < first.plan.segments.size(); ++i) {
    EXPECT_EQ(first.plan.segments[i].start_m, again.plan.segments[i].start_m);
    EXPECT_EQ(first.plan.segments[i].end_m, again.plan.segments[i].end_m);
    EXPECT_EQ(first.plan.segments[i].material, again.plan.segments[i].material);
  }
  EXPECT_NE(first.route_m, other.route_m);
}

}  // namespace setsquare::building_test
