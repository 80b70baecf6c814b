// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/growing_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <Eigen/Core>
#include <limits>
#include <memory>
#include <utility>

#include "tests/mapping/driven_building.hpp"
#include "tests/mapping/tracked_world.hpp"

namespace setsquare::growing_map_test {

using testing::corridor_around_a_block;
using testing::drive;
using testing::scans_on_drive;
using testing::way_around_the_block;

constexpr double kNoise_m = 0.01;

std::vector<Scan> scans_on(const std::vector<Eigen::Vector2d>& way) {
  return scans_on_drive(corridor_around_a_block(), drive(way), kNoise_m, testing::kAllAround);
}

TrackSteps steps_of(const std::vector<Scan>& scans) {
  LogTracker tracker{MapperParams{}};
  TrackSteps all;
  for (const Scan& scan : scans) {
    TrackSteps steps;
    (void)tracker.add(scan, std::nullopt, steps);
    if (steps.begins_again) all.steps.clear();
    for (TrackStep& step : steps.steps) all.steps.push_back(std::move(step));
  }
  return all;
}

SensorReports with_odometry(std::size_t num_scans) {
  SensorReports sensors;
  sensors.num_with_odometry = num_scans;
  return sensors;
}

TrackSteps begun_again(const std::vector<TrackStep>& steps) {
  return {.begins_again = true, .steps = steps};
}

void expect_same(const Map& a, const Map& b) {
  ASSERT_EQ(a.scans.size(), b.scans.size());
  for (std::size_t i = 0; i < a.scans.size(); ++i) {
    ASSERT_EQ(a.scans[i].T_map_base, b.scans[i].T_map_base) << i;
    ASSERT_EQ(a.scans[i].heading_sigma_rad, b.scans[i].heading_sigma_rad) << i;
    ASSERT_EQ(a.scans[i].open_sigma_m, b.scans[i].open_sigma_m) << i;
  }
  EXPECT_EQ(a.track.T_odom_sensor, b.track.T_odom_sensor);
  EXPECT_EQ(a.keyframes, b.keyframes);
  EXPECT_EQ(a.graph.T_map_node, b.graph.T_map_node);
  EXPECT_EQ(a.closures.size(), b.closures.size());
  ASSERT_EQ(a.kept_scans.size(), b.kept_scans.size());
  for (std::size_t i = 0; i < a.kept_scans.size(); ++i) {
    ASSERT_EQ(a.kept_scans[i].index, b.kept_scans[i].index) << i;
  }
  ASSERT_EQ(a.sessions.size(), b.sessions.size());
  for (std::size_t s = 0; s < a.sessions.size(); ++s) {
    EXPECT_EQ(a.sessions[s].first_scan, b.sessions[s].first_scan);
    EXPECT_EQ(a.sessions[s].num_scans, b.sessions[s].num_scans);
    EXPECT_EQ(a.sessions[s].recency, b.sessions[s].recency);
  }
  EXPECT_EQ(a.num_with_odometry, b.num_with_odometry);
}

/// Of another drive in the same building: loops are closed in it, and nothing of it may be left.
TrackSteps steps_that_do_not_hold() { return steps_of(scans_on(way_around_the_block())); }

std::vector<Scan> half_a_round() { return scans_on({{15.0, 3.0}, {15.0, 11.0}, {4.0, 11.0}}); }

TEST(GrowingMap, StepsThatBeginAgainLeaveNothingOfThoseBefore) {
  const TrackSteps held = steps_of(scans_on({{1.0, 1.0}, {15.0, 1.0}, {15.0, 11.0}, {6.0, 11.0}}));
  GrowingMap direct{MapperParams{}};
  direct.add(TrackSteps{held});
  GrowingMap again{MapperParams{}};
  again.add(steps_that_do_not_hold());
  again.add(begun_again(held.steps));
  EXPECT_EQ(again.num_scans(), held.steps.size());
  expect_same(again.make({}), direct.make({}));
}

TEST(GrowingMap, StepsThatBeginAgainLeaveTheMapThatIsGoneOnWith) {
  GrowingMap known{MapperParams{}};
  known.add(steps_of(scans_on(way_around_the_block())));
  const Map before = known.make(with_odometry(7));
  const TrackSteps held = steps_of(half_a_round());
  GrowingMap direct{MapperParams{}};
  direct.add(before);
  direct.add(TrackSteps{held});
  GrowingMap again{MapperParams{}};
  again.add(before);
  again.add(steps_that_do_not_hold());
  again.add(begun_again({}));
  GrowingMap untouched{MapperParams{}};
  untouched.add(before);
  expect_same(again.make({}), untouched.make({}));
  again.add(TrackSteps{held});
  const Map map = again.make(with_odometry(5));
  expect_same(map, direct.make(with_odometry(5)));
  EXPECT_EQ(map.num_with_odometry, 12U);
  EXPECT_EQ(map.sessions.size(), 2U);
}

/// All behind a step moved: tracking was wrong there and knows nothing of it.
void bend(std::vector<TrackStep>& steps, std::size_t first, const Pose2& T_step_bent) {
  const Pose2 T_odom_step = steps[first].scan.T_odom_sensor;
  const Pose2 T_odom_bent = T_odom_step * T_step_bent * T_odom_step.inverse();
  for (std::size_t i = first; i < steps.size(); ++i) {
    steps[i].scan.T_odom_sensor = T_odom_bent * steps[i].scan.T_odom_sensor;
    if (!steps[i].keyframe) continue;
    auto moved = std::make_shared<Keyframe>(*steps[i].keyframe->keyframe);
    moved->T_odom_sensor = T_odom_bent * moved->T_odom_sensor;
    moved->T_odom_body = T_odom_bent * moved->T_odom_body;
    steps[i].keyframe->keyframe = std::move(moved);
  }
}

bool is_contradicted(const Map& map) {
  return std::ranges::any_of(map.doubts, [](const MapDoubt& doubt) {
    return doubt.kind == DoubtKind::kContradictingPairs;
  });
}

// Live maps are drawn so: what is wrong with a loop that was just closed is told before the end.
TEST(GrowingMap, AMapOnTheWayIsAuditedAsSoonAsTheRobotIsBack) {
  TrackSteps all = steps_of(driven_building(BuildingClass::kOffice, 2012).scans);
  const std::size_t half = all.steps.size() / 2;
  bend(all.steps, half, {0.7, 0.5, 0.0});
  const auto middle = all.steps.begin() + static_cast<std::ptrdiff_t>(half);
  MapperParams params;
  params.closing.verdict.min_score = 2.0;  // No loop is closed, ...
  params.audit.max_mendings = 0;           // ... and none mended.
  GrowingMap growing{params};
  growing.add({.steps = {all.steps.begin(), middle}});
  EXPECT_FALSE(is_contradicted(growing.make_next({})));
  growing.add({.steps = {middle, all.steps.end()}});
  const Map on_the_way = growing.make_next({});
  ASSERT_TRUE(on_the_way.audit);
  EXPECT_TRUE(is_contradicted(on_the_way));
  params.audit.is_on = false;
  GrowingMap unaudited{params};
  unaudited.add(std::move(all));
  EXPECT_FALSE(is_contradicted(unaudited.make_next({})));
}

// A spread beyond what can be computed: nothing that was tracked may be lost.
TEST(GrowingMap, ATrackThatCannotBeSolvedIsTheMapInDoubt) {
  GrowingMap growing{MapperParams{}};
  growing.add(steps_of(scans_on(way_around_the_block())));
  Map broken = growing.make({});
  ASSERT_GT(broken.track.motions.size(), 20U);
  broken.track.motions[20].covariance.translation_m2 = Eigen::Vector2d(1e14, 1e-4).asDiagonal();
  GrowingMap again{MapperParams{}};
  again.add(broken);
  const Map map = again.make({});
  ASSERT_EQ(map.doubts.size(), 1U);
  EXPECT_EQ(map.doubts[0].kind, DoubtKind::kNotClosed);
  EXPECT_EQ(map.doubts[0].num_scans, map.scans.size());
  ASSERT_EQ(map.scans.size(), broken.scans.size());
  EXPECT_TRUE(map.closures.empty());
  for (std::size_t i = 0; i < map.scans.size(); ++i) {
    EXPECT_TRUE(map.scans[i].is_placed);
    EXPECT_EQ(map.scans[i].position_sigma_m, std::numeric_limits<double>::infinity());
    const Pose2 moved = map.scans.front().T_map_sensor.inverse() * map.scans[i].T_map_sensor;
    const Pose2 tracked = map.track.T_odom_sensor.front().inverse() * map.track.T_odom_sensor[i];
    EXPECT_NEAR((moved.translation() - tracked.translation()).norm(), 0.0, 1e-6) << i;
  }
}

}  // namespace setsquare::growing_map_test
