// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/bag/bag_log.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "setsquare/io/bags/mcap_writer.hpp"
#include "setsquare/io/logs/bag/scan_messages.hpp"
#include "setsquare/io/logs/log_writer.hpp"
#include "setsquare/io/ros/builtin_definitions.hpp"
#include "setsquare/io/ros/message_encoder.hpp"
#include "tests/io/read_all.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::bag_log_test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::make_generator;
using ::testing::Not;
using testing::PoseNear;
using testing::read_all;
using testing::ReadLog;
using ::testing::SizeIs;
using testing::uniform;
using ::testing::Values;

constexpr testing::PoseTolerance kTight{.translation_m = 1e-9, .rotation_rad = 1e-9};

Timestamp at_s(double seconds) { return timestamp_from_seconds(seconds); }

/// A recording made message by message.
class Recording {
 public:
  Recording() : file_([this](std::string_view bytes) { bytes_ += bytes; }) {}

  template <typename MessageType>
  void add(const std::string& topic,
           const std::string& type,
           const MessageType& message,
           double log_time_s) {
    const auto [entry, is_new] = channels_.try_emplace(topic);
    if (is_new) {
      entry->second = file_.add_channel(
          topic, type, ros::builtin_definition(plain_type_name(type), MessageEncoding::kCdr));
    }
    ros::encode(message, cdr_);
    file_.write(entry->second, at_s(log_time_s), cdr_.message());
  }

  void add_scan(double stamp_s,
                const std::string& frame = "laser",
                std::optional<double> log_time_s = {},
                double last_range_m = 5.0) {
    ros::LaserScan scan;
    scan.stamp = at_s(stamp_s);
    scan.frame_id = frame;
    scan.angle_min_rad = -1.0;
    scan.angle_max_rad = 1.0;
    scan.angle_increment_rad = 0.5;
    scan.range_max_m = 30.0;
    scan.ranges_m = {1.0, 2.0, 3.0, 4.0, last_range_m};
    add("/scan", "sensor_msgs/msg/LaserScan", scan, log_time_s.value_or(stamp_s));
  }

  void add_place(const std::string& parent,
                 const std::string& child,
                 const Eigen::Vector3d& position_m,
                 const Eigen::Quaterniond& rotation,
                 double log_time_s = 0.0) {
    ros::TransformStamped transform;
    transform.frame_id = parent;
    transform.child_frame_id = child;
    transform.translation_m = position_m;
    transform.rotation = rotation;
    add("/tf_static", "tf2_msgs/msg/TFMessage", ros::TfMessage{{transform}}, log_time_s);
  }

  void add_odometry(const std::string& topic,
                    double stamp_s,
                    const Pose2& pose,
                    std::optional<double> log_time_s = {}) {
    ros::Odometry odometry;
    odometry.stamp = at_s(stamp_s);
    odometry.frame_id = "odom";
    odometry.child_frame_id = "base_link";
    odometry.position_m = {pose.x_m, pose.y_m, 0.0};
    odometry.orientation = quaternion_from_yaw(pose.theta_rad);
    add(topic, "nav_msgs/msg/Odometry", odometry, log_time_s.value_or(stamp_s));
  }

  [[nodiscard]] ReadLog read(const LogOptions& options = {}) {
    file_.finish();
    return read_all(bytes_, options);
  }

 private:
  std::string bytes_;
  McapWriter file_;
  ros::CdrWriter cdr_;
  std::map<std::string, McapWriter::Channel> channels_;
};

TEST(BagLog, ReadsAScanAsItWasSent) {
  Recording recording;
  recording.add_scan(3.5);
  const ReadLog log = recording.read();
  ASSERT_THAT(log.records, SizeIs(1));
  const LogRecord& record = log.records[0];
  EXPECT_EQ(record.sensor, "/scan");
  EXPECT_EQ(record.stamp, at_s(3.5));
  EXPECT_EQ(record.scan.ranges_m, (std::vector{1.0, 2.0, 3.0, 4.0, 5.0}));
  EXPECT_NEAR(record.scan.bearing_step_rad, 0.5, 1e-7);
  EXPECT_EQ(record.scan.max_range_m, 30.0);
  EXPECT_FALSE(record.T_odom_base.has_value());
}

/// Of scans whose range_max is 30 m; all of them wait for a transform until the recording ends.
std::string words_on_ranges_beyond_max(const std::function<double(int)>& range_m) {
  Recording recording;
  for (int i = 0; i < 40; ++i) recording.add_scan(1.0 + 0.1 * i, "laser", {}, range_m(i));
  std::string words;
  const ReadLog log = recording.read();
  for (const std::string& remark : log.problems.remarks) {
    if (remark.find("above range_max") != std::string::npos) words += remark;
  }
  return words;
}

TEST(BagLog, MeasurementsAboveRangeMaxAreToldAndCodesAreNot) {
  EXPECT_THAT(words_on_ranges_beyond_max([](int i) { return 31.0 + 0.01 * i; }),
              HasSubstr("--max-range"));
  EXPECT_THAT(words_on_ranges_beyond_max([](int i) { return i < 20 ? 81.83 : 81.91; }), IsEmpty());
  EXPECT_THAT(words_on_ranges_beyond_max([](int) { return 65.533; }), IsEmpty());
}

/// A CARMEN log has SICK's codes from 81.83 m on for "nothing seen".
TEST(BagLog, NoReturnsOfACarmenLogStayWhatTheyWereAndAreNotTold) {
  std::string carmen;
  for (int i = 0; i < 30; ++i) {
    carmen += fmt::format("FLASER 5 2.5 81.83 {:.2f} 81.91 4.25 0 0 0 0 0 0 {:.1f} host {:.1f}\n",
                          3.0 + 0.01 * i,
                          0.2 * i,
                          0.2 * i);
  }
  std::string bytes;
  const auto writer =
      make_log_writer(LogFormat::kMcap, [&bytes](std::string_view more) { bytes += more; });
  const ReadLog original = read_all(carmen);
  for (const LogRecord& record : original.records) writer->write(record);
  writer->finish();
  const ReadLog converted = read_all(bytes);
  EXPECT_THAT(converted.problems.remarks, Not(Contains(HasSubstr("range_max"))));
  std::size_t num_scans = 0;
  for (const LogRecord& record : converted.records) {
    if (record.kind != RecordKind::kScan) continue;
    ++num_scans;
    EXPECT_EQ(record.scan.ranges_m[1], 81.83);
    EXPECT_EQ(record.scan.ranges_m[3], 81.91);
    EXPECT_EQ(record.scan.outcome(3), BeamOutcome::kNoReturn);
  }
  EXPECT_EQ(num_scans, 30U);
}

TEST(BagLog, ALaserThatNoTransformPlacesIsAtTheRobotsFrameAndItIsReported) {
  Recording recording;
  recording.add_scan(3.5);
  const ReadLog log = recording.read();
  ASSERT_THAT(log.records, SizeIs(1));
  EXPECT_EQ(log.records[0].scan.T_base_sensor, Pose2{});
  EXPECT_THAT(log.problems.remarks, Contains(HasSubstr("place on the robot is not known")));
}

TEST(BagLog, TakesTheMountingFromTheFrames) {
  Recording recording;
  recording.add_scan(0.5);  // before its place is known
  recording.add_place("base_link", "mast", {0.1, 0.0, 1.0}, quaternion_from_yaw(kPi / 2.0), 1.0);
  recording.add_place("/mast", "/laser", {0.2, 0.0, 0.0}, quaternion_from_yaw(0.0), 1.0);
  recording.add_scan(1.5);
  const ReadLog log = recording.read();
  ASSERT_THAT(log.records, SizeIs(2));
  for (const LogRecord& record : log.records) {
    EXPECT_THAT(record.scan.T_base_sensor, PoseNear(Pose2{0.1, 0.2, kPi / 2.0}, kTight));
  }
  EXPECT_THAT(log.problems.remarks, Not(Contains(HasSubstr("place"))));
}

TEST(BagLog, AScannerUpsideDownTurnsTheOtherWay) {
  Recording recording;
  const Eigen::Quaterniond rolled(Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitX()));
  recording.add_place("base_link", "laser", {0.0, 0.0, 0.5}, rolled);
  recording.add_scan(1.0);
  const ReadLog log = recording.read();
  ASSERT_THAT(log.records, SizeIs(1));
  // The first beam, 1 rad to the right in the scanner's frame, is to the left seen from above.
  const Scan& scan = log.records[0].scan;
  EXPECT_NEAR(wrap_to_pi(scan.bearing_rad(0) + scan.T_base_sensor.theta_rad), 1.0, 1e-6);
  EXPECT_EQ(scan.ranges_m[0], 1.0);
}

TEST(BagLog, GivesTheOdometryAtTheScansStamp) {
  Recording recording;
  recording.add_odometry("/odom", 1.0, {0.0, 0.0, 0.0});
  recording.add_scan(1.25);
  recording.add_odometry("/odom", 1.5, {1.0, -2.0, 0.2});
  const ReadLog log = recording.read();
  ASSERT_THAT(log.records, SizeIs(1));
  ASSERT_TRUE(log.records[0].T_odom_base.has_value());
  EXPECT_THAT(*log.records[0].T_odom_base, PoseNear(Pose2{0.5, -1.0, 0.1}, kTight));
}

TEST(BagLog, TakesWheelsBeforeOtherOdometryUnlessToldOtherwise) {
  const auto record = [](Recording& recording) {
    recording.add_odometry("/visual/odom", 1.0, {5.0, 0.0, 0.0});
    recording.add_odometry("/odom", 1.0, {1.0, 0.0, 0.0});
    recording.add_scan(1.0);
  };
  Recording by_default;
  record(by_default);
  const ReadLog log = by_default.read();
  EXPECT_THAT(log.records.at(0).T_odom_base.value(), PoseNear(Pose2{1.0, 0.0, 0.0}, kTight));
  EXPECT_THAT(log.problems.remarks, Contains(HasSubstr("/odom, not from /visual/odom")));
  Recording told;
  record(told);
  LogOptions options;
  options.odometry_topic = "/visual/odom";
  EXPECT_THAT(told.read(options).records.at(0).T_odom_base.value(),
              PoseNear(Pose2{5.0, 0.0, 0.0}, kTight));
}

TEST(BagLog, OdometryOfAnotherClockIsPairedByTheTimeOfRecording) {
  Recording recording;
  for (int i = 0; i < 10; ++i) {
    ros::Odometry odometry;
    odometry.stamp = at_s(5000.0 + 0.1 * i);  // another computer's clock
    odometry.child_frame_id = "base_link";
    odometry.position_m.x() = i;
    recording.add("/odom", "nav_msgs/msg/Odometry", odometry, 100.0 + 0.1 * i);
  }
  recording.add_scan(100.45);
  const ReadLog log = recording.read();
  ASSERT_THAT(log.records, SizeIs(1));
  ASSERT_TRUE(log.records[0].T_odom_base.has_value());
  EXPECT_NEAR(log.records[0].T_odom_base->x_m, 4.5, 1e-6);
}

/// A drive of 100 s, made into a recording by a program within a tenth of a second.
class MadeInNoTime : public ::testing::Test {
 protected:
  static constexpr int kNumScans = 200;

  void drive() {
    for (int i = 0; i < kNumScans; ++i) {
      const double stamp_s = 1000.0 + 0.5 * i;
      for (int step = 0; step < 20; ++step) {
        const double x_m = i + 0.05 * step;
        recording_.add_odometry("/odom", stamp_s + 0.025 * step, {x_m, 0.0, 0.0}, log_time_s());
      }
      recording_.add_scan(stamp_s + 0.25, "laser", log_time_s());
    }
  }
  double log_time_s() { return 5e8 + 2e-5 * num_messages_++; }

  Recording recording_;

 private:
  int num_messages_ = 0;
};

TEST_F(MadeInNoTime, ScansHaveTheirOdometry) {
  recording_.add_place("base_link", "laser", {0.5, 0.0, 0.0}, Eigen::Quaterniond::Identity());
  drive();
  const ReadLog log = recording_.read();
  ASSERT_THAT(log.records, SizeIs(kNumScans));
  for (int i = 0; i < kNumScans; ++i) {
    const auto& T_odom_base = log.records[static_cast<std::size_t>(i)].T_odom_base;
    ASSERT_TRUE(T_odom_base.has_value()) << i;
    EXPECT_NEAR(T_odom_base->x_m, i + 0.5, 1e-6) << i;
  }
}

/// The scan waits for a place, but no longer than the odometry is kept.
TEST_F(MadeInNoTime, ScansOfALaserWithoutAPlaceHaveTheirOdometry) {
  drive();
  for (const LogRecord& record : recording_.read().records) {
    EXPECT_TRUE(record.T_odom_base.has_value()) << record.stamp.seconds();
  }
}

TEST(BagLog, TellsThatTheOdometryIsOfAnotherTime) {
  Recording recording;
  for (int i = 0; i < 10; ++i) recording.add_odometry("/odom", 100.0 + 0.1 * i, {});
  for (int i = 0; i < 10; ++i) recording.add_scan(102.0 + 0.1 * i);
  EXPECT_THAT(recording.read().problems.remarks,
              Contains(HasSubstr("/odom has no pose near the stamps of 10 of the 10 scans")));
}

TEST(BagLog, AMessageWithoutAStampHasTheTimeOfRecording) {
  Recording recording;
  ros::LaserScan scan;
  scan.angle_increment_rad = 0.5;
  scan.angle_max_rad = 0.5;
  scan.range_max_m = 30.0;
  scan.ranges_m = {1.0, 2.0};
  recording.add("/scan", "sensor_msgs/msg/LaserScan", scan, 77.0);
  const ReadLog log = recording.read();
  ASSERT_THAT(log.records, SizeIs(1));
  EXPECT_EQ(log.records[0].stamp, at_s(77.0));
  EXPECT_THAT(log.problems.remarks, Contains(HasSubstr("no usable stamp")));
}

TEST(BagLog, ADamagedMessageIsSkippedAndCounted) {
  Recording recording;
  recording.add_scan(1.0);
  ros::LaserScan empty;
  empty.stamp = at_s(2.0);
  recording.add("/scan", "sensor_msgs/msg/LaserScan", empty, 2.0);
  recording.add_scan(3.0);
  const ReadLog log = recording.read();
  EXPECT_THAT(log.records, SizeIs(2));
  EXPECT_EQ(log.problems.num_damaged, 1U);
}

/// A scan of decimal numbers, as drivers print them.
LogRecord decimal_record(std::mt19937_64& generator, double stamp_s) {
  LogRecord record;
  record.sensor = "/scan";
  record.stamp = record.scan.stamp = at_s(stamp_s);
  record.scan.first_bearing_rad = -kPi / 2.0;
  record.scan.bearing_step_rad = kPi / 180.0;
  record.scan.max_range_m = 81.9;
  for (int beam = 0; beam < 180; ++beam) {
    record.scan.ranges_m.push_back(std::round(uniform(generator, 0.0, 90.0) * 1000.0) / 1000.0);
  }
  record.T_odom_base = Pose2{uniform(generator, -0.1, 0.1), uniform(generator, -0.1, 0.1), 0.7};
  return record;
}

/// As BagLog's loop does, but one by one and with the standard library's rounding.
double plain_meant_decimal(float range_m) {
  const double rounded = std::nearbyint(double{range_m} * 1e4) / 1e4;
  return static_cast<float>(rounded) == range_m ? rounded : double{range_m};
}

TEST(BagLog, RangesAreTheDecimalsThatWereMeantOrTheFloatsThemselves) {
  auto generator = make_generator();
  std::string bytes;
  const auto writer =
      make_log_writer(LogFormat::kMcap, [&bytes](std::string_view piece) { bytes += piece; });
  std::vector<std::vector<float>> sent_m;
  for (std::size_t num_beams = 1; num_beams < 40; ++num_beams) {  // Whole vectors and their rests.
    std::vector<float> ranges_m(num_beams);
    for (float& range_m : ranges_m) {
      const double any_m = std::exp(uniform(generator, -9.0, 12.0));
      const bool is_decimal = generator() % 2 == 0;
      range_m = static_cast<float>(is_decimal ? std::round(any_m * 1000.0) / 1000.0 : any_m);
    }
    ranges_m[generator() % num_beams] = std::numeric_limits<float>::infinity();
    ranges_m[generator() % num_beams] = 1e30F;
    LogRecord record = decimal_record(generator, static_cast<double>(num_beams));
    record.scan.ranges_m.assign(ranges_m.begin(), ranges_m.end());
    writer->write(record);
    sent_m.push_back(ranges_m);
  }
  writer->finish();
  const ReadLog log = read_all(bytes);
  ASSERT_THAT(log.records, SizeIs(sent_m.size()));
  for (std::size_t i = 0; i < sent_m.size(); ++i) {
    std::vector<double> expected_m;
    for (const float range_m : sent_m[i]) expected_m.push_back(plain_meant_decimal(range_m));
    EXPECT_EQ(log.records[i].scan.ranges_m, expected_m) << testing::test_seed();
  }
}

class PackedBagLog : public ::testing::TestWithParam<ChunkPacking> {};

INSTANTIATE_TEST_SUITE_P(Packings,
                         PackedBagLog,
                         Values(ChunkPacking::kNone, ChunkPacking::kLz4, ChunkPacking::kZstd));

// Law: a log of decimal numbers comes back from a bag as it was, although the bag holds float32.
TEST_P(PackedBagLog, DecimalsSurviveTheFloatsOfABag) {
  auto generator = make_generator();
  std::string bytes;
  const auto writer = make_log_writer(
      LogFormat::kMcap, [&bytes](std::string_view piece) { bytes += piece; }, GetParam());
  std::vector<LogRecord> records;
  for (int i = 0; i < 20; ++i) {
    records.push_back(decimal_record(generator, 1000.0 + 0.1 * i));
    writer->write(records.back());
  }
  writer->finish();
  const ReadLog log = read_all(bytes);
  EXPECT_THAT(log.error, IsEmpty());
  ASSERT_THAT(log.records, SizeIs(records.size()));
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(log.records[i].stamp, records[i].stamp);
    EXPECT_EQ(log.records[i].scan.ranges_m, records[i].scan.ranges_m);
    EXPECT_EQ(log.records[i].scan.first_bearing_rad, records[i].scan.first_bearing_rad);
    EXPECT_EQ(log.records[i].scan.bearing_step_rad, records[i].scan.bearing_step_rad);
    EXPECT_EQ(log.records[i].scan.max_range_m, records[i].scan.max_range_m);
    ASSERT_TRUE(log.records[i].T_odom_base.has_value());
    EXPECT_THAT(*log.records[i].T_odom_base, PoseNear(*records[i].T_odom_base, kTight));
  }
}

}  // namespace
}  // namespace setsquare::bag_log_test
