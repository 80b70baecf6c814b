// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "setsquare/io/logs/carmen/log.hpp"
#include "tests/io/read_all.hpp"
#include "tests/support/pose_matchers.hpp"

namespace setsquare::carmen_log_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::PoseNear;
using testing::read_all;
using ::testing::SizeIs;

/// "FLASER n ranges... laser_pose robot_pose stamp host stamp".
std::string flaser(int num_beams, const std::string& poses, const std::string& stamp) {
  std::ostringstream line;
  line << "FLASER " << num_beams;
  for (int beam = 0; beam < num_beams; ++beam) line << ' ' << beam + 1 << ".50";
  line << ' ' << poses << ' ' << stamp << " host 0.5\n";
  return line.str();
}

const std::string kNoPose = "0 0 0 0 0 0";

LogOptions everything() {
  LogOptions options;
  options.scans_only = false;
  options.sensor = "all";
  return options;
}

TEST(CarmenLog, FlaserGivesRangesStampOdometryAndMounting) {
  const auto log = read_all(
      "FLASER 2 1.25 81.83 1.460000 2.000000 1.570796 1.500000 2.000000 1.570796 "
      "976052857.337530 host 0.1\n"
      "FLASER 2 1.25 2.5 0.960000 0.000000 0.000000 1.000000 0.000000 0.000000 976052858.5 h 1\n");
  ASSERT_THAT(log.records, SizeIs(2));
  const LogRecord& record = log.records[0];
  EXPECT_EQ(record.sensor, "FLASER");
  EXPECT_EQ(to_string(record.stamp), "976052857.337530");
  EXPECT_EQ(record.scan.stamp, record.stamp);
  EXPECT_THAT(record.scan.ranges_m, ElementsAre(1.25, 81.83));
  EXPECT_EQ(record.scan.outcome(0), BeamOutcome::kReturn);
  EXPECT_EQ(record.scan.outcome(1), BeamOutcome::kNoReturn);
  EXPECT_THAT(*record.T_odom_base, PoseNear(Pose2{1.5, 2.0, 1.570796}, testing::PoseTolerance{}));
  EXPECT_EQ(record.position, 1U);
  EXPECT_EQ(log.records[1].position, 2U);
}

TEST(CarmenLog, BearingsByTheNumberOfBeams) {
  const double degree = rad_from_deg(1.0);
  for (const auto& [num_beams, step_deg] :
       {std::pair{180, 1.0}, {181, 1.0}, {360, 0.5}, {361, 0.5}}) {
    const auto log = read_all(flaser(num_beams, kNoPose, "1.0"));
    ASSERT_THAT(log.records, SizeIs(1));
    EXPECT_NEAR(log.records[0].scan.first_bearing_rad, -90.0 * degree, 1e-12) << num_beams;
    EXPECT_NEAR(log.records[0].scan.bearing_step_rad, step_deg * degree, 1e-12) << num_beams;
  }
}

TEST(CarmenLog, OptionsSetTheAnglesAndTheReach) {
  LogOptions options;
  options.field_of_view_rad = rad_from_deg(90.0);
  options.bearing_step_rad = rad_from_deg(-30.0);
  options.max_range_m = 3.0;
  const auto log = read_all(flaser(4, kNoPose, "1.0"), options);
  ASSERT_THAT(log.records, SizeIs(1));
  EXPECT_NEAR(log.records[0].scan.bearing_rad(0), rad_from_deg(45.0), 1e-12);
  EXPECT_NEAR(log.records[0].scan.bearing_rad(3), rad_from_deg(-45.0), 1e-12);
  EXPECT_EQ(log.records[0].scan.outcome(3), BeamOutcome::kNoReturn);
}

TEST(CarmenLog, TheStepAloneGivesASymmetricSweep) {
  for (const double step_deg : {0.25, -0.25, 0.5}) {
    for (const int num_beams : {1, 4, 181, 682}) {
      LogOptions options;
      options.bearing_step_rad = rad_from_deg(step_deg);
      const auto log = read_all(flaser(num_beams, kNoPose, "1.0"), options);
      ASSERT_THAT(log.records, SizeIs(1));
      const Scan& scan = log.records[0].scan;
      EXPECT_EQ(scan.bearing_step_rad, *options.bearing_step_rad);
      const auto last = static_cast<std::size_t>(num_beams - 1);
      EXPECT_NEAR(scan.bearing_rad(0) + scan.bearing_rad(last), 0.0, 1e-12) << num_beams;
    }
  }
}

TEST(CarmenLog, NoReturnCodesOfAllOurLogsAreNoReturns) {
  const auto log = read_all("FLASER 4 50.0 81.83 81.91 49.99 0 0 0 0 0 0 1.0 h 0\n");
  ASSERT_THAT(log.records, SizeIs(1));
  for (const std::size_t beam : {0, 1, 2}) {
    EXPECT_EQ(log.records[0].scan.outcome(beam), BeamOutcome::kNoReturn) << beam;
  }
  EXPECT_EQ(log.records[0].scan.outcome(3), BeamOutcome::kReturn);
}

TEST(CarmenLog, TheReachMayBeAParameter) {
  const auto log =
      read_all("PARAM robot_front_laser_max 20.5 1.0 h 0\n" + flaser(2, kNoPose, "1.0"));
  ASSERT_THAT(log.records, SizeIs(1));
  EXPECT_EQ(log.records[0].scan.max_range_m, 20.5);
}

TEST(CarmenLog, RobotlaserCarriesItsAnglesOnEveryLine) {
  const std::string line =
      "ROBOTLASER1 0 -1.562070 3.141593 0.017453 81.900000 0.010000 0 3 1.0 81.83 55.5 2 10 20 "
      "0.22 0.0 0.1 0.0 0.0 0.1 0.1 0.0 0.0 0.0 0.0 100.200000 host 0.2\n";
  const auto log = read_all(line);
  ASSERT_THAT(log.records, SizeIs(1));
  const Scan& scan = log.records[0].scan;
  EXPECT_EQ(scan.first_bearing_rad, -1.562070);
  EXPECT_EQ(scan.bearing_step_rad, 0.017453);
  EXPECT_EQ(scan.outcome(1), BeamOutcome::kNoReturn);  // an error code below the stated 81.90
  EXPECT_EQ(scan.outcome(2), BeamOutcome::kReturn);
  EXPECT_EQ(to_string(log.records[0].stamp), "100.200000");
}

TEST(CarmenLog, RawlaserHasNoPoses) {
  const auto log =
      read_all("RAWLASER2 0 -0.5 1.0 0.5 30.0 0.010000 0 3 1.0 2.0 3.0 0 100.175000 host 0.175\n");
  ASSERT_THAT(log.records, SizeIs(1));
  EXPECT_EQ(log.records[0].sensor, "RAWLASER2");
  EXPECT_FALSE(log.records[0].T_odom_base);
  EXPECT_EQ(log.records[0].scan.T_base_sensor, Pose2{});
}

TEST(CarmenLog, OdometryAndTruePosesOnDemand) {
  const std::string text =
      "ODOM 1.0 2.0 0.5 0.25 -0.1 0.0 10.0 h 0\n"
      "TRUEPOS 3.0 4.0 0.5 1.0 2.0 0.5 11.0 h 0\n" +
      flaser(2, kNoPose, "12.0");
  const auto log = read_all(text, everything());
  ASSERT_THAT(log.records, SizeIs(3));
  EXPECT_EQ(log.records[0].kind, RecordKind::kOdometry);
  EXPECT_EQ(*log.records[0].T_odom_base, (Pose2{1.0, 2.0, 0.5}));
  EXPECT_EQ(log.records[0].forward_m_per_s, 0.25);
  EXPECT_EQ(log.records[0].turn_rad_per_s, -0.1);
  EXPECT_TRUE(log.records[0].scan.ranges_m.empty());
  EXPECT_EQ(log.records[1].kind, RecordKind::kTruePose);
  EXPECT_EQ(*log.records[1].T_map_base, (Pose2{3.0, 4.0, 0.5}));
  EXPECT_THAT(read_all(text).records, SizeIs(1));
}

TEST(CarmenLog, DamagedLinesAreSkippedCountedAndNamed) {
  const std::string good = flaser(2, kNoPose, "1.0");
  const std::string text =
      good + "FLASER 2 1.5 x 0 0 0 0 0 0 1.0 h 0\n" +  // line 2
      "FLASER 3 1.5 2.5 0 0 0 0 0 0 1.0 h 0\n" +       // a range short
      "FLASER 2 1.5 2.5 0 0 0 0 0 0 1.0 h\n" +         // no logger stamp
      "FLASER 2 1.5 2.5 0 0 0 0 0 nan 1.0 h 0\n" + "FLASER 2 1.5 2.5 0 0 0 0 0 0 soon h 0\n" +
      "FLASER 2 1.5 2.5 0 0 0 0 0 0 9e9 h 0\n" + "FLASER 99999999 1.5\n" +
      "FLA5ER 1 1 0 0 0 0 0 0 1.0 h 0\n" +
      "ROBOTLASER1 0 0 0 4 30 0 0 3 1 1 1 0 0 0 0 0 0 0 0 0 0 0 0 3.0 h 0\n" + good;
  const auto log = read_all(text);
  EXPECT_THAT(log.records, SizeIs(2));
  EXPECT_EQ(log.problems.num_damaged, 9U);
  ASSERT_THAT(log.problems.first, SizeIs(9));
  EXPECT_EQ(log.problems.first[0].location, "line 2");
  EXPECT_THAT(log.problems.first[0].reason, HasSubstr("FLASER"));
  EXPECT_EQ(log.problems.first[8].location, "line 10");
  EXPECT_THAT(summary(log.problems), HasSubstr("9 damaged records skipped, the first at line 2"));
}

TEST(CarmenLog, OnlyTheFirstProblemsAreKeptAllAreCounted) {
  std::string text = flaser(2, kNoPose, "1.0");
  for (int i = 0; i < 100; ++i) text += "FLASER broken\n";
  const auto log = read_all(text);
  EXPECT_EQ(log.problems.num_damaged, 100U);
  EXPECT_THAT(log.problems.first, SizeIs(LogProblems::kMaxKept));
}

std::string small_log() {
  return "# a comment\nPARAM robot_front_laser_max 80.99 1.0 h 0\n" +
         flaser(3, "0.1 0.2 0.3 0.1 0.2 0.3", "1.25") + "ODOM 1 2 3 0 0 0 1.5 h 0\n" +
         "ROBOTLASER1 0 -1.5 3.0 1.5 81.9 0.01 0 3 1.0 2.0 3.0 1 7 0 0 0 0 0 0 0 0 0 0 0 1.75 h "
         "0\n" +
         flaser(3, "0.1 0.2 0.3 0.1 0.2 0.3", "2.0");
}

TEST(CarmenLog, CutAtEveryOffset) {
  const std::string text = small_log();
  std::size_t num_before = 0;
  for (std::size_t length = 0; length <= text.size(); ++length) {
    const auto log = read_all(text.substr(0, length), everything());
    EXPECT_GE(log.records.size(), num_before) << length;  // nothing that was whole is lost
    EXPECT_LE(log.problems.num_damaged, 1U) << length;    // the last line at most
    for (const LogProblem& problem : log.problems.first) {
      EXPECT_THAT(problem.reason, HasSubstr("the file ends in this line")) << length;
    }
    num_before = log.records.size();
  }
  EXPECT_EQ(num_before, 4U);
}

TEST(CarmenLog, AFlippedBitCostsAtMostTwoLines) {
  const std::string text = small_log();
  for (std::size_t at = 0; at < text.size(); ++at) {
    for (const int bit : {1, 8, 32, 128}) {
      std::string flipped = text;
      flipped[at] = static_cast<char>(flipped[at] ^ bit);
      const auto log = read_all(flipped, everything());
      EXPECT_GE(log.records.size(), 2U) << at;
    }
  }
}

TEST(CarmenLog, WhatIsReadDoesNotDependOnHowBytesArrive) {
  const std::string text = small_log();
  const auto whole = read_all(text, everything());
  for (const std::size_t at_once : {1, 5, 64}) {
    const auto log =
        read_all(std::make_unique<testing::TricklingSource>(text, at_once), everything());
    ASSERT_EQ(log.records.size(), whole.records.size());
    for (std::size_t i = 0; i < log.records.size(); ++i) {
      EXPECT_EQ(log.records[i].stamp, whole.records[i].stamp);
      EXPECT_EQ(log.records[i].scan.ranges_m, whole.records[i].scan.ranges_m);
    }
  }
}

}  // namespace setsquare::carmen_log_test
