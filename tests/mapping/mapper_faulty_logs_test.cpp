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

Map map_of(const Log& log, bool has_odometry) {
  Mapper mapper;
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    mapper.add(log.scans[i], has_odometry ? std::optional(log.odometry[i]) : std::nullopt);
  }
  return mapper.finish();
}

void expect_true_poses(const Map& map, const Log& log) {
  ASSERT_EQ(map.scans.size(), log.scans.size());
  for (std::size_t i = 0; i < log.truth.size(); ++i) {
    ASSERT_THAT(between(map.scans[0].T_map_sensor, map.scans[i].T_map_sensor),
                PoseNear(between(log.truth[0], log.truth[i]),
                         PoseTolerance{.translation_m = 0.06, .rotation_rad = rad_from_deg(0.7)}))
        << i;
  }
}

void expect_mapped(const Log& log) { expect_true_poses(map_of(log, true), log); }

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

/// From `hangs` on, up to `again`, the scanner sends its last scan again and again.
Log log_of_hung_scanner(std::size_t hangs, std::size_t again) {
  Log log;
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    if (i > hangs && i < again) log.scans[i] = log.scans[hangs];
    log.scans[i].stamp.ns = 100'000'000 * static_cast<std::int64_t>(i);
  }
  return log;
}

std::size_t num_unseen(const Map& map) {
  std::size_t num = 0;
  for (const MapDoubt& doubt : map.doubts) {
    if (doubt.kind == DoubtKind::kNotSeen) num += doubt.num_scans;
  }
  return num;
}

void expect_errors_within_three_spreads(const Map& map, const Log& log) {
  for (std::size_t i = 0; i < log.truth.size(); ++i) {
    const Pose2 off = between(between(log.truth[0], log.truth[i]),
                              between(map.scans[0].T_map_sensor, map.scans[i].T_map_sensor));
    EXPECT_LT(std::hypot(off.x_m, off.y_m), 0.1 + 3.0 * map.scans[i].position_sigma_m) << i;
  }
}

TEST(MapperFaultyLogs, WhereTheScannerHungIsNotKnownWithoutOdometry) {
  const std::size_t num_scans = Log().scans.size();
  const Log to_the_end = log_of_hung_scanner(num_scans / 2, num_scans);
  const Map map = map_of(to_the_end, false);
  EXPECT_EQ(num_unseen(map), num_scans - num_scans / 2 - 1);
  expect_errors_within_three_spreads(map, to_the_end);

  const Log for_a_while = log_of_hung_scanner(num_scans / 2, num_scans / 2 + 30);
  const Map found_again = map_of(for_a_while, false);
  EXPECT_EQ(num_unseen(found_again), 29U);
  expect_errors_within_three_spreads(found_again, for_a_while);
}

/// The robot drives 0.25 m from one new scan to the next.
TEST(MapperFaultyLogs, ADriverThatSendsEachScanFiveTimesTellsNothingBetween) {
  Log log = log_of_hung_scanner(0, 0);
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    log.scans[i].ranges_m = log.scans[i - i % 5].ranges_m;
  }
  const Map map = map_of(log, false);
  const auto num_lost = std::ranges::count(map.scans, TrackStatus::kLost, &MappedScan::status);
  EXPECT_GT(num_lost, log.scans.size() / 2);
  expect_errors_within_three_spreads(map, log);
}

TEST(MapperFaultyLogs, WhereTheScannerHungIsWhereTheWheelsHaveIt) {
  const std::size_t num_scans = Log().scans.size();
  Log log = log_of_hung_scanner(num_scans / 2, num_scans);
  // The robot rests for a while meanwhile: the scan is no newer for that.
  const std::size_t rest = 3 * num_scans / 4;
  for (std::size_t i = rest; i < rest + 10; ++i) log.truth[i] = log.truth[rest];
  log.odometry = log.truth;
  const Map map = map_of(log, true);
  EXPECT_EQ(num_unseen(map), num_scans - num_scans / 2 - 1);
  expect_true_poses(map, log);
}

TEST(MapperFaultyLogs, ARobotThatStandsIsNotInDoubtThoughItsScannerHasNoNoise) {
  Log log;
  log.truth.insert(log.truth.begin() + 100, 60, log.truth[100]);
  log.scans = scans_on_drive(l_shaped_room(), log.truth, 0.0, Fan{360, -kPi, kTwoPi / 360.0});
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    log.scans[i].stamp.ns = 100'000'000 * static_cast<std::int64_t>(i);
  }
  const Map map = map_of(log, false);
  ASSERT_EQ(log.scans[110].ranges_m, log.scans[120].ranges_m);
  EXPECT_EQ(map.scans[120].status, TrackStatus::kTracked);
  EXPECT_TRUE(map.doubts.empty());
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
