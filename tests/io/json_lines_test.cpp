// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "setsquare/io/logs/json_lines/log.hpp"
#include "setsquare/io/logs/json_lines/writer.hpp"
#include "tests/io/random_records.hpp"
#include "tests/io/read_all.hpp"

namespace setsquare::json_lines_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::read_all;
using ::testing::SizeIs;

LogOptions everything() {
  LogOptions options;
  options.sensor = "all";
  options.scans_only = false;
  return options;
}

TEST(JsonLines, AScanWithAllItsMembers) {
  const auto log = read_all(
      "{\"stamp\": 1700000000.123456789, \"sensor\": \"front\", \"angle_min\": -1.57, "
      "\"angle_step\": 0.5, \"ranges\": [1.25, null, 2.5e0], \"odometry\": [1, 2, 0.5], "
      "\"mounting\": [0.1, 0, -0.5], \"range_min\": 0.1, \"range_max\": 30, "
      "\"time_increment\": 0.001, \"scan_time\": 0.1, \"forward_speed\": 0.5, \"turn_rate\": -1, "
      "\"unknown\": {\"a\": [1, \"}]\\\"\", null]}}\n");
  ASSERT_THAT(log.records, SizeIs(1)) << log.error;
  const LogRecord& record = log.records[0];
  EXPECT_EQ(record.stamp.ns, 1'700'000'000'123'456'789);
  EXPECT_EQ(record.sensor, "front");
  EXPECT_EQ(record.scan.first_bearing_rad, -1.57);
  EXPECT_EQ(record.scan.bearing_step_rad, 0.5);
  EXPECT_TRUE(std::isnan(record.scan.ranges_m[1]));
  EXPECT_EQ(record.scan.ranges_m[2], 2.5);
  EXPECT_EQ(record.T_odom_base, (Pose2{1.0, 2.0, 0.5}));
  EXPECT_EQ(record.scan.T_base_sensor, (Pose2{0.1, 0.0, -0.5}));
  EXPECT_EQ(record.scan.min_range_m, 0.1);
  EXPECT_EQ(record.scan.max_range_m, 30.0);
  EXPECT_EQ(record.scan.time_increment_s, 0.001);
  EXPECT_EQ(record.scan.scan_time_s, 0.1);
  EXPECT_EQ(record.forward_m_per_s, 0.5);
  EXPECT_EQ(record.turn_rad_per_s, -1.0);
}

TEST(JsonLines, OdometryAndTruePosesAlone) {
  const std::string text =
      "{\"stamp\":1,\"odometry\":[1,2,3]}\n"
      "{\"stamp\":2,\"true_pose\":[4,5,0.5],\"odometry\":[1,2,0.5]}\n"
      "\n# remark\n"
      "{\"time\":3,\"angle_min\":0,\"angle_increment\":0.1,\"ranges\":[1]}\r\n";
  const auto log = read_all(text, everything());
  ASSERT_THAT(log.records, SizeIs(3)) << log.error;
  EXPECT_EQ(log.records[0].kind, RecordKind::kOdometry);
  EXPECT_EQ(log.records[1].kind, RecordKind::kTruePose);
  EXPECT_EQ(log.records[1].T_map_base, (Pose2{4.0, 5.0, 0.5}));
  EXPECT_EQ(log.records[2].kind, RecordKind::kScan);
  EXPECT_EQ(log.records[2].position, 5U);
  EXPECT_EQ(log.records[2].scan.max_range_m, 50.0);
  EXPECT_THAT(read_all(text).records, SizeIs(1));
}

TEST(JsonLines, NumbersThatJsonDoesNotHave) {
  const auto log = read_all(
      "{\"stamp\":1,\"angle_min\":0,\"angle_step\":0.1,\"range_max\":\"inf\",\"ranges\":"
      "[null,NaN,\"nan\",Infinity,\"inf\",-Infinity,\"-inf\", \"1.5\"]}\n");
  ASSERT_THAT(log.records, SizeIs(1)) << log.error;
  const auto& ranges_m = log.records[0].scan.ranges_m;
  ASSERT_THAT(ranges_m, SizeIs(8));
  for (const std::size_t beam : {0, 1, 2}) EXPECT_TRUE(std::isnan(ranges_m[beam])) << beam;
  for (const std::size_t beam : {3, 4}) EXPECT_EQ(ranges_m[beam], INFINITY) << beam;
  for (const std::size_t beam : {5, 6}) EXPECT_EQ(ranges_m[beam], -INFINITY) << beam;
  EXPECT_EQ(ranges_m[7], 1.5);
  EXPECT_EQ(log.records[0].scan.max_range_m, INFINITY);
}

TEST(JsonLines, TextWithEscapes) {
  const auto log = read_all(
      "{\"stamp\":1,\"angle_min\":0,\"angle_step\":1,\"ranges\":[1],"
      "\"sensor\":\"a\\\"\\\\\\u00e4\\ud83d\\ude00\\n\"}\n");
  ASSERT_THAT(log.records, SizeIs(1)) << log.error;
  EXPECT_EQ(log.records[0].sensor, "a\"\\\xc3\xa4\xf0\x9f\x98\x80\n");
}

/// Names come from other logs, in whatever encoding.
TEST(JsonLines, ANameInAnotherEncodingReadsBack) {
  LogRecord record;
  record.sensor = std::string("\xe4\x00\xff\\\t\"", 6);
  record.scan.bearing_step_rad = 0.5;
  record.scan.max_range_m = 30.0;
  record.scan.ranges_m = {1.0, 2.0};
  std::string text;
  append_json_record(text, record);
  const auto log = read_all(text);
  ASSERT_THAT(log.records, SizeIs(1)) << log.error;
  EXPECT_EQ(log.records[0].sensor, record.sensor);
}

TEST(JsonLines, DamagedLinesAreCountedWithTheirReason) {
  const std::string good = "{\"stamp\":1,\"angle_min\":0,\"angle_step\":0.1,\"ranges\":[1,2]}\n";
  for (const auto& [line, reason] :
       {std::pair{"[1,2]", "no JSON object"},
        {"{\"stamp\":1", "comma or } expected"},
        {"{\"stamp\":1} x", "text behind the JSON object"},
        {"{\"stamp\":\"x\",\"odometry\":[1,2,3]}", "\"stamp\" is not as it must be"},
        {"{\"stamp\":1e30}", "\"stamp\" is not as it must be"},
        {"{\"stamp\":1}", "no \"ranges\", \"odometry\", \"true_pose\" or \"turn_rate\""},
        {"{\"ranges\":[1],\"angle_min\":0,\"angle_step\":1}", "no \"stamp\""},
        {"{\"stamp\":1,\"ranges\":[1],\"angle_min\":0}", "no \"angle_step\""},
        {"{\"stamp\":1,\"ranges\":[1],\"angle_step\":1}", "no \"angle_min\""},
        {"{\"stamp\":1,\"ranges\":[],\"angle_min\":0,\"angle_step\":1}", "\"ranges\" is not"},
        {"{\"stamp\":1,\"ranges\":[1,],\"angle_min\":0,\"angle_step\":1}", "\"ranges\" is not"},
        {"{\"stamp\":1,\"ranges\":[1 2],\"angle_min\":0,\"angle_step\":1}", "\"ranges\" is not"},
        {"{\"stamp\":1,\"ranges\":[1,2],\"angle_min\":0,\"angle_step\":9}", "angles or limits"},
        {"{\"stamp\":1,\"odometry\":[1,2]}", "\"odometry\" is not"},
        {"{\"stamp\":1,\"odometry\":[1,2,null]}", "\"odometry\" is not"},
        {"{\"stamp\":1,\"x\":[[[}", "\"x\" is not"},
        {"{\"stamp\":1,\"sensor\":\"\\ud800\",\"odometry\":[1,2,3]}", "\"sensor\" is not"}}) {
    const auto log = read_all(good + line + "\n" + good, everything());
    EXPECT_THAT(log.records, SizeIs(2)) << line;
    ASSERT_THAT(log.problems.first, SizeIs(1)) << line;
    EXPECT_EQ(log.problems.first[0].location, "line 2");
    EXPECT_THAT(log.problems.first[0].reason, HasSubstr(reason)) << line;
  }
}

TEST(JsonLines, AnotherKindOfJsonIsNamed) {
  for (const char* text : {"{\n  \"stamp\": 1\n}\n", "[{\"stamp\": 1}]\n"}) {
    EXPECT_EQ(read_all(text).error, "test.log: JSON, but not of one object per line");
  }
}

LogRecord any_record(std::mt19937_64& generator) {
  LogRecord record = testing::any_scan(generator);
  if (generator() % 3 == 0) record.forward_m_per_s = testing::any_number(generator);
  if (generator() % 3 == 0) record.turn_rad_per_s = testing::any_number(generator);
  const auto kind = generator() % 5;
  if (kind > 2) return record;
  if (kind == 2) {
    LogRecord turn;
    turn.kind = RecordKind::kTurnRate;
    turn.sensor = record.sensor;
    turn.stamp = turn.scan.stamp = record.stamp;
    turn.turn_rad_per_s = testing::any_number(generator);
    return turn;
  }
  record.kind = kind == 0 ? RecordKind::kOdometry : RecordKind::kTruePose;
  record.scan = Scan{};
  record.scan.stamp = record.stamp;
  record.T_odom_base = testing::any_pose(generator);
  if (kind == 1) record.T_map_base = testing::any_pose(generator);
  return record;
}

TEST(JsonLinesWriter, WhatIsWrittenReadsBackBitForBit) {
  auto generator = testing::make_generator();
  std::string text;
  std::vector<LogRecord> records;
  for (int i = 0; i < 300; ++i) {
    records.push_back(any_record(generator));
    append_json_record(text, records.back());
  }
  JsonLinesLog log(std::make_unique<InputBuffer>(make_memory_source(text)), everything());
  LogRecord read;
  for (const LogRecord& record : records) {
    ASSERT_TRUE(log.read(read)) << log.problems().first.front().reason;
    EXPECT_EQ(read.sensor, record.sensor);
    EXPECT_EQ(testing::bits_of(read), testing::bits_of(record));
  }
  EXPECT_FALSE(log.read(read));
  EXPECT_TRUE(log.problems().empty());
}

TEST(JsonLinesWriter, RefusesWhatWouldNotReadBack) {
  auto generator = testing::make_generator();
  std::string text;
  LogRecord record = testing::any_scan(generator);
  record.scan.ranges_m.clear();
  EXPECT_THROW(append_json_record(text, record), ParameterError);
  record.kind = RecordKind::kOdometry;
  record.T_odom_base.reset();
  EXPECT_THROW(append_json_record(text, record), ParameterError);
  record.kind = RecordKind::kTruePose;
  EXPECT_THROW(append_json_record(text, record), ParameterError);
}

TEST(JsonLines, CutAnywhereGivesTheRecordsBeforeAndAWord) {
  const std::string line = "{\"stamp\":1,\"angle_min\":0,\"angle_step\":0.1,\"ranges\":[1,null]}\n";
  const std::string whole = line + line + line;
  for (std::size_t size = line.size(); size < whole.size(); ++size) {
    const auto log = read_all(whole.substr(0, size));
    const bool lacks_only_the_end = (size + 1) % line.size() == 0;
    EXPECT_EQ(log.records.size(), (size + (lacks_only_the_end ? 1 : 0)) / line.size()) << size;
    const bool is_cut = size % line.size() != 0 && !lacks_only_the_end;
    ASSERT_EQ(!log.problems.empty(), is_cut) << size;
    if (!is_cut) continue;
    EXPECT_THAT(log.problems.first[0].reason, HasSubstr("the file ends in this line")) << size;
  }
}

}  // namespace setsquare::json_lines_test
