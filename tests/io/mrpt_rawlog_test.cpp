// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "setsquare/io/logs/mrpt/rawlog.hpp"
#include "tests/io/mrpt_bytes.hpp"
#include "tests/io/read_all.hpp"
#include "tests/support/pose_matchers.hpp"

namespace setsquare::mrpt_rawlog_test {

using ::testing::HasSubstr;
using testing::mrpt_container;
using testing::mrpt_movement;
using testing::mrpt_object;
using testing::mrpt_odometry;
using testing::mrpt_scan;
using testing::MrptScan;
using testing::PoseNear;
using testing::read_all;
using ::testing::SizeIs;

LogOptions everything() {
  LogOptions options;
  options.scans_only = false;
  options.sensor = "all";
  return options;
}

std::string scan(const MrptScan& fields = {}) { return mrpt_scan(7, 3, fields); }

std::string comment() { return mrpt_object("CObservationComment", 0, std::string(30, '\5')); }

TEST(MrptRawlog, EveryVersionOfScanAndPose) {
  for (int version = 0; version <= 7; ++version) {
    for (int pose_version = 0; pose_version <= 3; ++pose_version) {
      const auto log = read_all(mrpt_scan(version, pose_version, {}));
      ASSERT_THAT(log.records, SizeIs(1)) << version << " " << pose_version;
      EXPECT_TRUE(log.problems.empty());
      const LogRecord& record = log.records[0];
      EXPECT_EQ(record.sensor, version >= 5 ? "FRONT" : "laser");
      EXPECT_EQ(to_string(record.stamp), version >= 3 ? "1136100000.500000" : "0.000000");
      EXPECT_NEAR(record.scan.first_bearing_rad, -1.5, 1e-12);
      EXPECT_NEAR(record.scan.bearing_step_rad, 1.0, 1e-12);
      EXPECT_THAT(record.scan.T_base_sensor,
                  PoseNear(Pose2{0.25, -0.5, 0.0}, testing::PoseTolerance{}));
      EXPECT_EQ(record.scan.outcome(0), BeamOutcome::kReturn);
      EXPECT_EQ(record.scan.outcome(2), BeamOutcome::kNoReturn);
      EXPECT_EQ(record.scan.outcome(3),
                version >= 1 ? BeamOutcome::kInvalid : BeamOutcome::kReturn);
    }
  }
}

TEST(MrptRawlog, ClockwiseAndUpsideDownScansTurnTheOtherWay) {
  const auto clockwise = read_all(scan({.is_right_to_left = false}));
  EXPECT_NEAR(clockwise.records.at(0).scan.first_bearing_rad, 1.5, 1e-12);
  EXPECT_NEAR(clockwise.records.at(0).scan.bearing_step_rad, -1.0, 1e-12);
  for (int pose_version = 0; pose_version <= 3; ++pose_version) {
    const auto hanging = read_all(mrpt_scan(7, pose_version, {.is_upside_down = true}));
    EXPECT_NEAR(hanging.records.at(0).scan.first_bearing_rad, 1.5, 1e-12) << pose_version;
    EXPECT_NEAR(hanging.records.at(0).scan.bearing_step_rad, -1.0, 1e-12);
  }
}

TEST(MrptRawlog, NamespacesInClassNamesMakeNoDifference) {
  std::string bytes = scan();
  const std::string name = "mrpt::obs::CObservation2DRangeScan";
  bytes = static_cast<char>(0x80U | name.size()) + name + bytes.substr(1 + 23);
  EXPECT_THAT(read_all(bytes).records, SizeIs(1));
}

TEST(MrptRawlog, FramesAndActionsGiveOdometryFromTheFirstScanOn) {
  std::string bytes;
  for (int version = 2; version <= 7; ++version) {
    bytes += mrpt_container("CSensoryFrame", 2, {scan()});
    bytes += mrpt_container("CActionCollection", 0, {mrpt_movement(version, 0.5, 0.0, kPi / 2.0)});
  }
  bytes += mrpt_container("CSensoryFrame", 2, {scan()});
  const auto log = read_all(bytes);
  EXPECT_TRUE(log.problems.empty());
  ASSERT_THAT(log.records, SizeIs(7));
  Pose2 T_odom_base;
  for (const LogRecord& record : log.records) {
    ASSERT_TRUE(record.T_odom_base);
    EXPECT_THAT(*record.T_odom_base, PoseNear(T_odom_base, testing::PoseTolerance{}));
    T_odom_base = T_odom_base * Pose2{0.5, 0.0, kPi / 2.0};
  }
}

TEST(MrptRawlog, OdometryObservationsAreAbsolute) {
  for (int version = 0; version <= 2; ++version) {
    const auto log =
        read_all(scan() + mrpt_odometry(version, 1.0, 2.0, 0.5) + scan(), everything());
    ASSERT_THAT(log.records, SizeIs(3)) << version;
    EXPECT_FALSE(log.records[0].T_odom_base);
    EXPECT_EQ(log.records[1].kind, RecordKind::kOdometry);
    EXPECT_EQ(log.records[1].sensor, "ODO");
    EXPECT_EQ(to_string(log.records[1].stamp), "1136100000.750000");
    if (version > 0) {
      EXPECT_EQ(log.records[1].forward_m_per_s, 0.5);
      EXPECT_EQ(log.records[1].turn_rad_per_s, 0.25);
    }
    EXPECT_EQ(*log.records[2].T_odom_base, (Pose2{1.0, 2.0, 0.5}));
  }
}

TEST(MrptRawlog, AnUnknownObjectIsCountedAndTheNextKnownOneFound) {
  const std::string bytes = scan() + comment() + scan() +
                            mrpt_container("CSensoryFrame", 2, {comment(), scan()}) + scan();
  const auto log = read_all(bytes);
  EXPECT_THAT(log.records, SizeIs(4));
  EXPECT_EQ(log.problems.num_damaged, 2U);
  EXPECT_EQ(log.problems.first.at(0).location, "offset " + std::to_string(scan().size()));
  EXPECT_THAT(log.problems.first.at(0).reason, HasSubstr("CObservationComment"));
}

TEST(MrptRawlog, ABigUnknownObjectIsPassedOverInBoundedMemory) {
  const std::string image = mrpt_object("CObservationImage", 5, std::string(5 << 20, '\x88'));
  const auto log = read_all(scan() + image + scan());
  EXPECT_THAT(log.records, SizeIs(2));
  EXPECT_EQ(log.problems.num_damaged, 1U);
}

TEST(MrptRawlog, ATiltedScannerGivesNoScanOfThePlane) {
  const double half = std::sqrt(0.5);
  std::string body = testing::raw(3.0F) + '\1' + testing::raw(30.0F);
  std::string pose;
  for (const double value : {0.0, 0.0, 0.0, half, 0.0, half, 0.0}) pose += testing::raw(value);
  body += mrpt_object("CPose3D", 2, pose) + testing::raw<std::uint32_t>(1) + testing::raw(1.0F) +
          '\1' + testing::raw(0.01F) + testing::raw(testing::mrpt_ticks(1.0)) + testing::raw(0.0F) +
          testing::raw<std::uint32_t>(0) + testing::raw(0.0);
  const auto log = read_all(mrpt_object("CObservation2DRangeScan", 6, body) + scan());
  EXPECT_THAT(log.records, SizeIs(1));
  EXPECT_THAT(log.problems.first.at(0).reason, HasSubstr("not mounted level"));
}

TEST(MrptRawlog, ABeamCountBeyondReasonIsDamage) {
  std::string bytes = mrpt_scan(6, 3, {});
  const std::size_t at = bytes.find(testing::raw<std::uint32_t>(4));
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at, 4, testing::raw<std::uint32_t>(0xfffffff0));
  const auto log = read_all(bytes + scan());
  EXPECT_THAT(log.records, SizeIs(1));
  EXPECT_EQ(log.problems.num_damaged, 1U);
}

std::string small_log() {
  return mrpt_container("CSensoryFrame", 2, {scan()}) +
         mrpt_container("CActionCollection", 0, {mrpt_movement(6, 0.5, 0.0, 0.1)}) +
         mrpt_container("CSensoryFrame", 2, {mrpt_scan(6, 1, {}), mrpt_odometry(2, 1, 2, 3)}) +
         scan();
}

TEST(MrptRawlog, CutAtEveryOffset) {
  const std::string bytes = small_log();
  std::size_t num_before = 0;
  for (std::size_t length = 1; length <= bytes.size(); ++length) {
    const auto log = read_all(bytes.substr(0, length), everything());
    EXPECT_GE(log.records.size(), num_before) << length;
    if (!log.records.empty()) {
      EXPECT_LE(log.problems.num_damaged, 2U) << length;
    }
    num_before = log.records.size();
  }
  EXPECT_EQ(num_before, 5U);
}

TEST(MrptRawlog, AFlippedBitCostsAtMostItsOwnObject) {
  const std::string bytes = small_log();
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const int bit : {1, 16, 128}) {
      std::string flipped = bytes;
      flipped[at] = static_cast<char>(flipped[at] ^ bit);
      const auto log = read_all(flipped, everything());
      const bool is_first_header = at < std::string("?CSensoryFrame").size();
      if (!is_first_header) {
        EXPECT_GE(log.records.size(), 4U) << at << " bit " << bit;
      }
    }
  }
}

TEST(MrptRawlog, WhatIsReadDoesNotDependOnHowBytesArrive) {
  const auto log =
      read_all(std::make_unique<testing::TricklingSource>(small_log(), 3), everything());
  EXPECT_THAT(log.records, SizeIs(5));
  EXPECT_TRUE(log.problems.empty());
}

}  // namespace setsquare::mrpt_rawlog_test
