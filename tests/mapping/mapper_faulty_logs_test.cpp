// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Logs that are spoilt in ways that real ones are: the mapper survives them without an option.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/seed.hpp"
#include "tests/support/simulated_drive.hpp"

namespace setsquare::mapper_faulty_logs_test {

using testing::between;
using testing::drive;
using testing::Fan;
using testing::l_shaped_room;
using testing::PoseNear;
using testing::PoseTolerance;
using testing::scans_on_drive;
using testing::way_around_the_room;

struct Log {
  std::vector<Pose2> truth = drive(way_around_the_room());
  std::vector<Pose2> odometry = truth;
  std::vector<Scan> scans = scans_on_drive(l_shaped_room(),
                                           truth,
                                           0.01,
                                           Fan{.num_beams = 1081,
                                               .first_bearing_rad = rad_from_deg(-135.0),
                                               .bearing_step_rad = rad_from_deg(0.25)});
};

void expect_mapped(const Log& log) {
  Mapper mapper;
  for (std::size_t i = 0; i < log.scans.size(); ++i) mapper.add(log.scans[i], log.odometry[i]);
  const Map map = mapper.finish();
  ASSERT_EQ(map.scans.size(), log.scans.size());
  for (std::size_t i = 0; i < log.truth.size(); ++i) {
    ASSERT_THAT(between(map.scans[0].T_map_sensor, map.scans[i].T_map_sensor),
                PoseNear(between(log.truth[0], log.truth[i]),
                         PoseTolerance{.translation_m = 0.06, .rotation_rad = rad_from_deg(0.7)}))
        << i;
  }
}

TEST(MapperFaultyLogs, OdometryOfZeros) {
  Log log;
  std::ranges::fill(log.odometry, Pose2{});
  expect_mapped(log);
}

TEST(MapperFaultyLogs, APoseOnAnotherPlanet) {
  Log log;
  log.odometry[100].x_m = 5.9e22;
  log.odometry[200].y_m = -1e12;
  expect_mapped(log);
}

TEST(MapperFaultyLogs, AScannerThatHangsNowAndThen) {
  Log log;
  for (std::size_t i = 60; i + 15 < log.scans.size(); i += 80) {
    for (std::size_t k = i + 1; k <= i + 15; ++k) log.scans[k].ranges_m = log.scans[i].ranges_m;
  }
  expect_mapped(log);
}

TEST(MapperFaultyLogs, ErrorCodesAndDust) {
  Log log;
  auto generator = testing::make_generator();
  for (Scan& scan : log.scans) {
    for (double& range_m : scan.ranges_m) {
      const double lot = testing::uniform(generator, 0.0, 1.0);
      if (lot < 0.05) range_m *= testing::uniform(generator, 0.1, 0.7);
      if (lot > 0.9) range_m = 0.001 * std::round(testing::uniform(generator, 1.0, 19.0));
    }
  }
  expect_mapped(log);
}

/// How far off the robot is mapped at most, without odometry, along corridors around a block, with
/// a scanner that sees 5 m far and four posts of its own robot.
double worst_with_posts_m(bool leaves_out_robot_parts) {
  const std::vector<Pose2> truth = drive(testing::way_around_the_block(), 0.1, rad_from_deg(6.0));
  MapperParams params;
  params.leaves_out_robot_parts = leaves_out_robot_parts;
  Mapper mapper(params);
  for (Scan& scan : scans_on_drive(testing::corridor_around_a_block(),
                                   truth,
                                   0.01,
                                   Fan{.num_beams = 360,
                                   .first_bearing_rad = -kPi,
                                   .bearing_step_rad = rad_from_deg(1.0)})) {
    scan.max_range_m = 5.0;
    for (const std::ptrdiff_t first_beam : {75, 130, 215, 270}) {
      std::fill_n(scan.ranges_m.begin() + first_beam, 16, 0.3);
    }
    mapper.add(scan);
  }
  const Map map = mapper.finish();
  double worst_m = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Pose2 mapped = between(map.scans[0].T_map_sensor, map.scans[i].T_map_sensor);
    worst_m = std::max(worst_m,
                       (mapped.translation() - between(truth[0], truth[i]).translation()).norm());
  }
  return worst_m;
}

TEST(MapperFaultyLogs, PostsOfTheRobotDoNotHoldItWhereItIs) {
  EXPECT_LT(worst_with_posts_m(true), 0.2);
  EXPECT_GT(worst_with_posts_m(false), 2.0);
}

}  // namespace setsquare::mapper_faulty_logs_test
