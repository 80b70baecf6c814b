// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/open_log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "setsquare/core/error.hpp"
#include "tests/io/read_all.hpp"
#include "tests/support/pose_matchers.hpp"

namespace setsquare::open_log_test {

using ::testing::Each;
using ::testing::Field;
using ::testing::HasSubstr;
using testing::PoseNear;
using testing::read_all;
using ::testing::SizeIs;

/// One scan of a laser at a pose of the robot, both written with `num_decimals`.
std::string scan_line(const std::string& name,
                      const Pose2& T_odom_sensor,
                      const Pose2& T_odom_base,
                      int num_decimals = 6) {
  char poses[200];
  std::snprintf(poses,
                sizeof poses,
                "%.*f %.*f %.*f %.*f %.*f %.*f",
                num_decimals,
                T_odom_sensor.x_m,
                num_decimals,
                T_odom_sensor.y_m,
                num_decimals,
                T_odom_sensor.theta_rad,
                num_decimals,
                T_odom_base.x_m,
                num_decimals,
                T_odom_base.y_m,
                num_decimals,
                T_odom_base.theta_rad);
  return name + " 2 1.0 2.0 " + poses + " 5.0 h 0\n";
}

/// A drive along which a laser is mounted at T_base_sensor.
std::string drive(const std::string& name, const Pose2& T_base_sensor, int num_decimals = 6) {
  std::string text;
  for (int i = 0; i < 100; ++i) {
    const Pose2 T_odom_base{0.1234567 * i, -0.0456789 * i, wrap_to_pi(0.0712345 * i)};
    text += scan_line(name, T_odom_base * T_base_sensor, T_odom_base, num_decimals);
  }
  return text;
}

TEST(OpenLog, MountingIsOneForTheWholeLogDespiteRounding) {
  const Pose2 mounting{-0.04, 0.0, 0.0};
  const auto log = read_all(drive("FLASER", mounting));
  ASSERT_THAT(log.records, SizeIs(100));
  for (const LogRecord& record : log.records) {
    EXPECT_THAT(record.scan.T_base_sensor, PoseNear(mounting, testing::PoseTolerance{}));
  }
  EXPECT_TRUE(log.problems.empty());
}

TEST(OpenLog, AMountingWithinTheRoundingIsNone) {
  const auto log = read_all(drive("FLASER", Pose2{}, 2));
  for (const LogRecord& record : log.records) EXPECT_EQ(record.scan.T_base_sensor, Pose2{});
}

TEST(OpenLog, ACoarselyWrittenMountingIsFoundToTheRounding) {
  const Pose2 mounting{0.22, 0.0, 0.0};
  const auto log = read_all(drive("FLASER", mounting, 2));
  EXPECT_THAT(log.records.back().scan.T_base_sensor,
              PoseNear(mounting, testing::PoseTolerance{.translation_m = 0.0101}));
}

TEST(OpenLog, AMountingThatIsNoneIsRemarked) {
  std::string text = drive("FLASER", Pose2{});
  text += scan_line("FLASER", Pose2{1.0, 0.0, 0.0}, Pose2{0.0, 0.0, 0.0});
  text += scan_line("FLASER", Pose2{2.0, 0.0, 0.0}, Pose2{0.0, 0.0, 0.0});
  const auto log = read_all(text);
  EXPECT_THAT(log.problems.remarks, SizeIs(1));  // reported once
  EXPECT_THAT(log.problems.remarks[0], HasSubstr("not constant"));
  EXPECT_EQ(log.records.back().scan.T_base_sensor, Pose2{});
}

TEST(OpenLog, AMountingOnNoRobotIsNone) {
  for (const double distance_m : {1e6, 1e30}) {
    std::string text;
    for (int i = 0; i < 10; ++i) {
      text += scan_line("FLASER", Pose2{distance_m, 0.0, 0.0}, Pose2{0.1 * i, 0.0, 0.0}, 3);
    }
    const auto log = read_all(text);
    ASSERT_THAT(log.records, SizeIs(10));
    EXPECT_EQ(log.records.back().scan.T_base_sensor, Pose2{});
    ASSERT_FALSE(log.problems.remarks.empty());
    EXPECT_THAT(log.problems.remarks[0], HasSubstr("on no robot"));
  }
}

// Converters that know no laser pose write zeros, or the mounting.
TEST(OpenLog, ALaserPoseThatNeverChangesIsNoPose) {
  for (const Pose2& written : {Pose2{}, Pose2{0.2, 0.0, 0.0}}) {
    std::string text;
    for (int i = 0; i < 300; ++i) {  // the robot sets out behind the log's head
      const Pose2 T_odom_base{3.0 + 0.01 * std::max(0, i - 100), 1.0, 0.5};
      text += scan_line("FLASER", written, T_odom_base);
    }
    const auto log = read_all(text);
    ASSERT_THAT(log.problems.remarks, SizeIs(1));
    EXPECT_THAT(log.problems.remarks[0], HasSubstr("stays the same"));
    EXPECT_THAT(log.records.back().scan.T_base_sensor, PoseNear(written, testing::PoseTolerance{}));
  }
}

TEST(OpenLog, CodesAreLeftOutAndScaleTakesTheReachAlong) {
  const std::string line =
      "ROBOTLASER1 0 -1.5 3.0 1.5 8000 0.01 0 3 1000 700 8000 0 0 0 0 0 0 0 0 0 0 0 0 5.0 h 0\n";
  LogOptions options;
  options.range_scale = 0.001;
  options.ignored_ranges_m = {0.7};
  const auto log = read_all(line, options);
  ASSERT_THAT(log.records, SizeIs(1));
  const Scan& scan = log.records[0].scan;
  EXPECT_EQ(scan.outcome(0), BeamOutcome::kReturn);
  EXPECT_EQ(scan.outcome(1), BeamOutcome::kInvalid);
  EXPECT_EQ(scan.outcome(2), BeamOutcome::kNoReturn);
  EXPECT_NEAR(scan.ranges_m[0], 1.0, 1e-12);
}

std::string two_lasers() {
  return scan_line("RLASER", Pose2{-0.2, 0.0, 3.141593}, Pose2{}) +
         scan_line("FLASER", Pose2{0.2, 0.0, 0.0}, Pose2{}) +
         scan_line("RLASER", Pose2{-0.2, 0.0, 3.141593}, Pose2{}) +
         scan_line("FLASER", Pose2{0.2, 0.0, 0.0}, Pose2{}) +
         "RAWLASER1 0 -0.5 1.0 0.5 30.0 0.01 0 3 1.0 2.0 3.0 0 100.0 host 0\n";
}

TEST(OpenLog, TheFrontLaserIsReadByDefault) {
  const auto log = read_all(two_lasers());
  EXPECT_EQ(log.front_sensor, "FLASER");
  EXPECT_THAT(log.records, SizeIs(2));
  EXPECT_THAT(log.records, Each(Field(&LogRecord::sensor, "FLASER")));
}

TEST(OpenLog, AnotherLaserOrAllByName) {
  LogOptions options;
  options.sensor = "RLASER";
  const auto rear = read_all(two_lasers(), options);
  EXPECT_THAT(rear.records, SizeIs(2));
  EXPECT_NEAR(std::abs(rear.records[0].scan.T_base_sensor.theta_rad), kPi, 1e-5);
  options.sensor = "all";
  EXPECT_THAT(read_all(two_lasers(), options).records, SizeIs(5));
  options.sensor = "SIDELASER";
  EXPECT_THAT(read_all(two_lasers(), options).error,
              HasSubstr("no scan of sensor SIDELASER; it has FLASER RAWLASER1 RLASER"));
}

TEST(OpenLog, SeveralLasersByNameEachWithANumber) {
  const std::string text = scan_line("FLASER", {}, {}) + scan_line("RLASER", {}, {}) +
                           scan_line("ROBOTLASER1", {}, {}) + scan_line("FLASER", {}, {});
  LogOptions options;
  options.sensor = "FLASER,RLASER";
  const auto log = read_all(text, options);
  ASSERT_THAT(log.records, SizeIs(3));
  EXPECT_EQ(log.records[0].scan.scanner, log.records[2].scan.scanner);
  EXPECT_NE(log.records[0].scan.scanner, log.records[1].scan.scanner);
}

TEST(OpenLog, AMountingThatIsGivenReplacesThatOfTheLog) {
  const Pose2 given{-0.2, 0.1, 3.0};
  LogOptions options;
  options.mountings["FLASER"] = given;
  const auto log = read_all(drive("FLASER", {0.3, 0.0, 0.0}), options);
  ASSERT_THAT(log.records, SizeIs(100));
  for (const LogRecord& record : log.records) EXPECT_EQ(record.scan.T_base_sensor, given);
  options.mountings["FLASER"].x_m = std::numeric_limits<double>::infinity();
  EXPECT_THAT(read_all(drive("FLASER", {}), options).error, HasSubstr("mountings"));
}

TEST(OpenLog, ALogWithoutScansIsAnError) {
  EXPECT_EQ(read_all("PARAM x 1 1 h 0\n").error, "test.log: no scan in this log");
  EXPECT_EQ(read_all("FLASER 1\n").error,
            "test.log: no scan in this log (1 damaged record skipped, at line 1: FLASER: ranges "
            "missing or not numbers)");
}

TEST(OpenLog, SaysWhatAFileIsThatIsNoLog) {
  EXPECT_EQ(read_all("").error, "test.log: the file is empty");
  EXPECT_THAT(read_all("#ROSBAG V2.0\n").error, HasSubstr("no scan in this log"));
  EXPECT_EQ(read_all("PK\x03\x04").error, "test.log: a zip archive, which cannot be read as a log");
  for (const std::string& text :
       {std::string("hello\n"), std::string(1000, '\0'), std::string("\xff\x80\xfe")}) {
    EXPECT_EQ(read_all(text).error,
              "test.log: neither a ROS bag, a CARMEN log, JSON lines, a CSV table of scans nor an "
              "MRPT rawlog");
  }
}

TEST(OpenLog, AByteOrderMarkCostsNoScan) {
  const auto log = read_all("\xef\xbb\xbf" + two_lasers());
  EXPECT_EQ(log.records.size(), read_all(two_lasers()).records.size());
  EXPECT_TRUE(log.problems.empty());
  EXPECT_EQ(read_all("\xef\xbb\xbf").error, "test.log: the file is empty");
}

TEST(OpenLog, SaysWhatToDoWithUtf16AndAnUnfetchedFile) {
  using namespace std::string_literals;
  for (const std::string& text : {"\xff\xfe"
                                  "F\0L\0"s,
                                  "\xfe\xff\0F\0L"s,
                                  "F\0L\0A\0S\0"s,
                                  "\0F\0L\0A\0S"s}) {
    EXPECT_EQ(read_all(text).error, "test.log: text in UTF-16: save it as UTF-8");
  }
  EXPECT_EQ(
      read_all("version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n").error,
      "test.log: a Git LFS pointer in place of the file: fetch it by git lfs pull");
}

TEST(OpenLog, OptionsOutOfTheirDomainAreNamed) {
  LogOptions options;
  options.max_range_m = -1.0;
  EXPECT_THAT(read_all(two_lasers(), options).error, HasSubstr("max_range_m"));
  options = {};
  options.field_of_view_rad = 7.0;
  EXPECT_THAT(read_all(two_lasers(), options).error, HasSubstr("field_of_view_rad"));
  options = {};
  options.bearing_step_rad = 0.0;
  EXPECT_THAT(read_all(two_lasers(), options).error, HasSubstr("bearing_step_rad"));
}

TEST(OpenLog, TheEndStaysTheEnd) {
  const auto reader = open_log(make_memory_source(two_lasers()), "test.log");
  while (reader->next() != nullptr) {
  }
  EXPECT_EQ(reader->next(), nullptr);
  EXPECT_EQ(reader->next(), nullptr);
}

}  // namespace setsquare::open_log_test
