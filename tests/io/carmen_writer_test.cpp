// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "setsquare/core/angle.hpp"
#include "setsquare/io/logs/carmen/writer.hpp"
#include "tests/io/read_all.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::carmen_writer_test {

using ::testing::HasSubstr;
using testing::PoseNear;

Scan random_scan(std::mt19937_64& generator, std::int64_t stamp_ns) {
  Scan scan{.stamp = {stamp_ns},
            .first_bearing_rad = rad_from_deg(-135.0),
            .bearing_step_rad = rad_from_deg(0.25),
            .min_range_m = 0.1,
            .max_range_m = 30.0,
            .ranges_m = {},
            .T_base_sensor = {0.2, -0.05, rad_from_deg(1.0)}};
  for (int i = 0; i < 1081; ++i) {
    scan.ranges_m.push_back(testing::uniform(generator, 0.05, 31.0));
  }
  return scan;
}

LogOptions with_true_poses() {
  LogOptions options;
  options.scans_only = false;
  return options;
}

TEST(CarmenWriter, EachScannerHasItsMessage) {
  std::mt19937_64 generator = testing::make_generator();
  std::string log;
  for (const std::uint32_t scanner : {0U, 1U}) {
    Scan scan = random_scan(generator, 0);
    scan.scanner = scanner;
    append_carmen_scan(log, scan, {});
  }
  EXPECT_TRUE(log.starts_with("ROBOTLASER1 "));
  EXPECT_THAT(log, HasSubstr("\nROBOTLASER2 "));
}

TEST(CarmenWriter, WhatIsWrittenReadsBack) {
  std::mt19937_64 generator = testing::make_generator();
  std::vector<Scan> scans;
  std::vector<Pose2> odometry;
  std::string log;
  for (int i = 0; i < 5; ++i) {
    scans.push_back(random_scan(generator, 976'052'857'337'530'000 + i * 100'000'001LL));
    odometry.push_back({1.5 * i, -0.25 * i, wrap_to_pi(2.0 * i)});
    const Pose2 truth{1.4 * i, 0.1, -0.3 * i};
    append_carmen_true_pose(log, scans[i].stamp, truth, odometry[i]);
    append_carmen_scan(log, scans[i], {odometry[i], 0.5, -0.1});
  }
  const testing::ReadLog read = testing::read_all(log, with_true_poses());
  ASSERT_EQ(read.error, "");
  EXPECT_TRUE(read.problems.remarks.empty());
  EXPECT_EQ(summary(read.problems), "");
  ASSERT_EQ(read.records.size(), 10U);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const LogRecord& truth = read.records[2 * i];
    EXPECT_EQ(truth.kind, RecordKind::kTruePose);
    EXPECT_EQ(truth.stamp, scans[i].stamp) << "to the nanosecond";
    EXPECT_THAT(*truth.T_odom_base, PoseNear(odometry[i], testing::PoseTolerance{1e-6, 1e-6}));
    const LogRecord& record = read.records[2 * i + 1];
    EXPECT_EQ(record.sensor, "ROBOTLASER1");
    EXPECT_EQ(record.stamp, scans[i].stamp);
    EXPECT_THAT(*record.T_odom_base, PoseNear(odometry[i], testing::PoseTolerance{1e-6, 1e-6}));
    EXPECT_THAT(record.scan.T_base_sensor,
                PoseNear(scans[i].T_base_sensor, testing::PoseTolerance{1e-4, 2e-6}));
    EXPECT_EQ(record.scan.max_range_m, 30.0);
    EXPECT_NEAR(record.scan.bearing_rad(0), scans[i].bearing_rad(0), 1e-9);
    EXPECT_NEAR(record.scan.bearing_rad(1080), scans[i].bearing_rad(1080), 1e-6);
    ASSERT_EQ(record.scan.num_beams(), scans[i].num_beams());
    for (std::size_t beam = 0; beam < scans[i].num_beams(); ++beam) {
      ASSERT_EQ(record.scan.outcome(beam), scans[i].outcome(beam)) << scans[i].ranges_m[beam];
      if (scans[i].outcome(beam) != BeamOutcome::kReturn) continue;
      ASSERT_NEAR(record.scan.ranges_m[beam], scans[i].ranges_m[beam], 0.5001e-3);
    }
  }
}

TEST(CarmenWriter, EveryBeamKeepsItsOutcome) {
  const double infinity = std::numeric_limits<double>::infinity();
  Scan scan;
  scan.first_bearing_rad = 1.0;
  scan.bearing_step_rad = -0.01;
  scan.max_range_m = 8.0004;
  scan.ranges_m = {
      std::nan(""), infinity, -infinity, 0.0, -1.0, 8.0004, 8.00039, 7.99999, 1e-5, 1e300, 2.5};
  std::string log;
  append_carmen_scan(log, scan, {});
  const testing::ReadLog read = testing::read_all(log);
  ASSERT_EQ(read.records.size(), 1U) << read.error;
  const Scan& again = read.records[0].scan;
  ASSERT_EQ(again.num_beams(), scan.num_beams());
  EXPECT_LT(again.bearing_step_rad, 0.0);
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    EXPECT_EQ(again.outcome(beam), scan.outcome(beam)) << "beam " << beam;
  }
}

TEST(CarmenWriter, WritesTheFieldsInTheOrderOfTheFormat) {
  Scan scan;
  scan.stamp.ns = 1'500'000'000;
  scan.first_bearing_rad = -0.5;
  scan.bearing_step_rad = 0.5;
  scan.max_range_m = 30.0;
  scan.ranges_m = {1.0, 2.25, 30.0};
  std::string log;
  append_carmen_scan(log, scan, {{1.0, 2.0, 0.5}, 0.25, -0.125});
  EXPECT_EQ(log,
            "ROBOTLASER1 0 -0.500000000 1.000000000 0.500000000 30.000 0.01 0 3 1.000 2.250 30.000 "
            "0 1.000000 2.000000 0.500000 1.000000 2.000000 0.500000 0.250000 -0.125000 0 0 0 "
            "1.500000 setsquare 1.500000\n");
  std::string truth;
  append_carmen_true_pose(truth, {-1'000'000'001}, {1.0, 2.0, 0.5}, {3.0, 4.0, -0.5});
  EXPECT_EQ(truth,
            "TRUEPOS 1.000000 2.000000 0.500000 3.000000 4.000000 -0.500000 -1.000000001 setsquare "
            "-1.000000001\n");
}

TEST(CarmenWriter, RefusesWhatTheFormatCannotState) {
  std::string log;
  Scan scan;
  scan.bearing_step_rad = 0.1;
  scan.ranges_m = {1.0, 2.0};
  EXPECT_THROW(append_carmen_scan(log, scan, {}), ParameterError) << "no finite maximum range";
  scan.max_range_m = 30.0;
  scan.bearing_step_rad = 0.0;
  EXPECT_THROW(append_carmen_scan(log, scan, {}), ParameterError) << "beams that all look one way";
  scan.ranges_m.clear();
  EXPECT_THROW(append_carmen_scan(log, scan, {}), ParameterError) << "no beam";
  EXPECT_EQ(log, "") << "no half line";
}

}  // namespace setsquare::carmen_writer_test
