// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/live_mapper.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <future>
#include <optional>
#include <random>
#include <thread>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "tests/support/seed.hpp"
#include "tests/support/simulated_drive.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare {
namespace live_mapper_test {

using testing::drive;
using testing::l_shaped_room;
using testing::scans_on_drive;
using testing::way_around_the_room;

constexpr testing::Fan kAllAround{360, -kPi, kTwoPi / 360.0};

struct Drive {
  std::vector<Scan> scans;
  std::vector<std::optional<Pose2>> T_wheels_base;  ///< One per scan.
};

/// Twice around the room, by wheels that are a share off.
Drive drive_twice(double share_off) {
  std::vector<Eigen::Vector2d> way = way_around_the_room();
  for (const Eigen::Vector2d& point : way_around_the_room()) way.push_back(point);
  const std::vector<Pose2> truth = drive(way, 0.08, rad_from_deg(5.0));
  Drive driven;
  driven.scans = scans_on_drive(l_shaped_room(), truth, 0.01, kAllAround);
  Pose2 wheels;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (i > 0) {
      const Pose2 step = truth[i - 1].inverse() * truth[i];
      const double scale = 1.0 + share_off;
      wheels = wheels * Pose2{scale * step.x_m, scale * step.y_m, scale * step.theta_rad};
    }
    driven.T_wheels_base.emplace_back(wheels);
  }
  return driven;
}

Map mapped(const Drive& drive) {
  Mapper mapper;
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    mapper.add(drive.scans[i], drive.T_wheels_base[i]);
  }
  return mapper.finish();
}

/// Draws as often as it can.
LiveMapperParams eager() {
  LiveMapperParams params;
  params.map_period_s = 0.01;
  params.max_drawing_share = 1.0;
  return params;
}

void expect_same(const Map& a, const Map& b) {
  ASSERT_EQ(a.scans.size(), b.scans.size());
  for (std::size_t i = 0; i < a.scans.size(); ++i) {
    ASSERT_EQ(a.scans[i].stamp, b.scans[i].stamp);
    ASSERT_EQ(a.scans[i].T_map_base, b.scans[i].T_map_base) << i;
    ASSERT_EQ(a.scans[i].heading_sigma_rad, b.scans[i].heading_sigma_rad) << i;
  }
  EXPECT_EQ(a.closures.size(), b.closures.size());
  EXPECT_EQ(a.keyframes, b.keyframes);
  EXPECT_EQ(a.odometry.num_ignored, b.odometry.num_ignored);
  EXPECT_EQ(occupancy_grid(a).values(), occupancy_grid(b).values());
}

/// The wheels are right, off by half (all is tracked again on the way), or by a hundredth.
class LiveMapperOnDrives : public ::testing::TestWithParam<double> {};

TEST_P(LiveMapperOnDrives, GivesTheMapThatMapperGives) {
  const Drive drive = drive_twice(GetParam());
  LiveMapper live(eager());
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    (void)live.add(drive.scans[i], drive.T_wheels_base[i]);
  }
  expect_same(live.finish(), mapped(drive));
  EXPECT_EQ(live.counts().num_scans, drive.scans.size());
  EXPECT_EQ(live.counts().num_behind, 0U);
}

TEST_P(LiveMapperOnDrives, GoesOnBehindAFinishedMap) {
  SCOPED_TRACE(testing::test_seed());

  std::mt19937_64 random = testing::make_generator();
  const Drive drive = drive_twice(GetParam());
  LiveMapper live(eager());
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    (void)live.add(drive.scans[i], drive.T_wheels_base[i]);
    if (random() % 150 == 0) (void)live.finish();
    if (random() % 100 == 0) (void)live.request_map();
  }
  expect_same(live.finish(), mapped(drive));
}

TEST_P(LiveMapperOnDrives, NeverFallsFartherBehindThanItMay) {
  const Drive drive = drive_twice(GetParam());
  LiveMapperParams params = eager();
  params.max_behind = 100;
  LiveMapper live(params);
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    (void)live.add(drive.scans[i], drive.T_wheels_base[i]);
    EXPECT_LE(live.counts().num_behind, params.max_behind);
  }
  expect_same(live.finish(), mapped(drive));
}

TEST_P(LiveMapperOnDrives, OdometryNeverJumpsAndFramesAgree) {
  const Drive drive = drive_twice(GetParam());
  LiveMapper live(eager());
  std::optional<LivePose> last;
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    const LivePose pose = live.add(drive.scans[i]);  // without the wheels
    EXPECT_EQ(pose.stamp, drive.scans[i].stamp);
    const Pose2 T_map_base = pose.T_map_odom * pose.T_odom_base;
    EXPECT_NEAR(T_map_base.x_m, pose.T_map_base.x_m, 1e-9);
    EXPECT_NEAR(T_map_base.y_m, pose.T_map_base.y_m, 1e-9);
    EXPECT_NEAR(
        std::remainder(T_map_base.theta_rad - pose.T_map_base.theta_rad, 2.0 * kPi), 0, 1e-9);
    if (last) {
      const Pose2 step = last->T_odom_base.inverse() * pose.T_odom_base;
      EXPECT_LT(std::hypot(step.x_m, step.y_m), 0.2) << i;
      EXPECT_LT(std::abs(step.theta_rad), 0.2) << i;
    }
    last = pose;
  }
}

INSTANTIATE_TEST_SUITE_P(Wheels, LiveMapperOnDrives, ::testing::Values(0.0, 0.5, 0.01));

/// What any thread may call, from another one while scans come: for the thread sanitizer, too.
TEST(LiveMapper, IsAskedByAnotherThreadWhileScansCome) {
  const Drive drive = drive_twice(0.01);
  LiveMapper live(eager());
  std::atomic<bool> is_ending = false;
  std::size_t num_asked = 0;
  std::thread asker([&] {
    std::size_t num_scans = 0;
    std::size_t num_in_map = 0;
    while (!is_ending) {
      const LiveCounts counts = live.counts();
      EXPECT_GE(counts.num_scans, num_scans);
      num_scans = counts.num_scans;
      std::future<LiveMapPtr> wanted = live.request_map();
      const LiveMapPtr last = live.last_map();
      const LiveMapPtr map = wanted.get();
      if (!map) continue;
      EXPECT_TRUE(!last || map->number >= last->number);
      EXPECT_GE(map->map.scans.size(), num_in_map);
      num_in_map = map->map.scans.size();
      ++num_asked;
    }
  });
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    (void)live.add(drive.scans[i], drive.T_wheels_base[i]);
  }
  const Map map = live.finish();
  is_ending = true;
  asker.join();
  EXPECT_GT(num_asked, 0U);
  expect_same(map, mapped(drive));
}

TEST(LiveMapper, TracksAllAgainWhereTheWheelsAreRefuted) {
  const Drive drive = drive_twice(0.5);
  LiveMapper live(eager());
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    (void)live.add(drive.scans[i], drive.T_wheels_base[i]);
  }
  (void)live.finish();
  EXPECT_EQ(live.counts().num_again, 1U);
}

TEST(LiveMapper, TellsOfMapsInTheirOrder) {
  const Drive drive = drive_twice(0.0);
  std::atomic<std::size_t> last = 0;
  LiveMapper live(eager(), [&](const LiveMapPtr& map) {
    EXPECT_EQ(map->number, last + 1);
    last = map->number;
  });
  for (const Scan& scan : drive.scans) (void)live.add(scan);
  const LiveMapPtr map = live.request_map().get();
  ASSERT_NE(map, nullptr);
  EXPECT_GE(last, 1U);
  EXPECT_EQ(live.last_map(), map);
  EXPECT_EQ(map->map.scans.size(), drive.scans.size());
}

/// Poses on the way are those of the finished map, but for what loops correct.
TEST(LiveMapper, PosesFollowTheMap) {
  const Drive drive = drive_twice(0.0);
  LiveMapper live(eager());
  for (const Scan& scan : drive.scans) (void)live.add(scan);
  (void)live.request_map().get();
  const LivePose pose = live.add(drive.scans.back());
  const Map map = live.finish();
  const Pose2 off = map.scans.back().T_map_base.inverse() * pose.T_map_base;
  EXPECT_LT(std::hypot(off.x_m, off.y_m), 0.02);
  EXPECT_LT(std::abs(off.theta_rad), 0.01);
  EXPECT_GT(pose.covariance(2, 2), 0.0);
}

TEST(LiveMapper, RefusesAScanWithoutGeometryAndGoesOn) {
  Drive drive = drive_twice(0.0);
  LiveMapper live(eager());
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    (void)live.add(drive.scans[i], drive.T_wheels_base[i]);
    Scan bad = drive.scans[i];
    bad.bearing_step_rad = std::nan("");
    if (i % 50 != 0) continue;
    EXPECT_THROW((void)live.add(bad), ParameterError);
  }
  expect_same(live.finish(), mapped(drive));
}

TEST(LiveMapper, CanBeGivenUpAtAnyMoment) {
  const Drive drive = drive_twice(0.5);
  for (const std::size_t num : {0U, 1U, 5U, 100U, 200U, 300U}) {
    LiveMapper live(eager());
    for (std::size_t i = 0; i < num; ++i) (void)live.add(drive.scans[i], drive.T_wheels_base[i]);
  }
}

TEST(LiveMapper, NamesABadParameter) {
  LiveMapperParams params;
  params.map_period_s = 0.0;
  EXPECT_THROW(LiveMapper{params}, ParameterError);
}

}  // namespace live_mapper_test
}  // namespace setsquare
