// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "setsquare/core/angle.hpp"
#include "setsquare/io/logs/csv/log.hpp"
#include "setsquare/io/logs/csv/writer.hpp"
#include "tests/io/random_records.hpp"
#include "tests/io/read_all.hpp"

namespace setsquare::csv_log_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::read_all;
using ::testing::SizeIs;

TEST(CsvLog, StampAnglesAndRangesWithAHeader) {
  const auto log = read_all("stamp,angle_min,angle_step,ranges\n1.5,-1.57,0.5,1.25,2.5,3\n");
  ASSERT_THAT(log.records, SizeIs(1)) << log.error;
  const LogRecord& record = log.records[0];
  EXPECT_EQ(record.stamp.ns, 1'500'000'000);
  EXPECT_EQ(record.scan.first_bearing_rad, -1.57);
  EXPECT_EQ(record.scan.bearing_step_rad, 0.5);
  EXPECT_EQ(record.scan.max_range_m, 50.0);
  EXPECT_THAT(record.scan.ranges_m, ElementsAre(1.25, 2.5, 3.0));
  EXPECT_FALSE(record.T_odom_base);
  EXPECT_EQ(record.position, 2U);
}

TEST(CsvLog, EverySeparatorWithAndWithoutAHeader) {
  for (const char* separator : {",", ";", "\t", " ", "  ", ", ", " ; ", " \t"}) {
    for (const bool has_header : {false, true}) {
      const auto row = [&](std::initializer_list<const char*> fields) {
        std::string line;
        for (const char* field : fields)
          line += line.empty() ? field : separator + std::string(field);
        return line + "\r\n";
      };
      const std::string header = row({"stamp", "angle_min", "angle_step", "ranges"});
      const auto log = read_all((has_header ? header : "") + "# remark\n\n" +
                                row({"10.25", "-1", "0.01", "1.5", "2.5"}) +
                                row({"10.5", "-1", "0.01", "1.5", "nan", "3.5"}));
      ASSERT_THAT(log.records, SizeIs(2)) << '"' << separator << "\" " << has_header << log.error;
      EXPECT_THAT(log.records[0].scan.ranges_m, ElementsAre(1.5, 2.5));
      EXPECT_THAT(log.records[1].scan.ranges_m, SizeIs(3));
      EXPECT_TRUE(log.problems.empty());
    }
  }
}

TEST(CsvLog, OtherNamesAndUnits) {
  const auto log = read_all(
      "Time_ns, sensor, angle_min_deg, angle_increment_deg, odom_x, odom_y, odom_theta_deg, "
      "mounting_x_mm, mounting_y_mm, mounting_theta_deg, range_max_m, range_0, range_1\n"
      "1700000000123456789, \"the front, \"\"low\"\"\", -90, 1, 1.5, 2, 180, 123, 0, 90, 8, 1, "
      "2\n");
  ASSERT_THAT(log.records, SizeIs(1)) << log.error;
  const LogRecord& record = log.records[0];
  EXPECT_EQ(record.stamp.ns, 1'700'000'000'123'456'789);
  EXPECT_EQ(record.sensor, "the front, \"low\"");
  EXPECT_EQ(record.scan.first_bearing_rad, rad_from_deg(-90.0));
  EXPECT_EQ(record.scan.bearing_step_rad, rad_from_deg(1.0));
  EXPECT_EQ(record.scan.max_range_m, 8.0);
  EXPECT_EQ(record.T_odom_base, (Pose2{1.5, 2.0, rad_from_deg(180.0)}));
  EXPECT_EQ(record.scan.T_base_sensor, (Pose2{0.123, 0.0, rad_from_deg(90.0)}));
}

TEST(CsvLog, StampsInEveryUnitAreExact) {
  for (const auto& [name, text] : {std::pair{"stamp", "1700000000.123456789"},
                                   {"timestamp_s", "1700000000.123456789"},
                                   {"time_ms", "1700000000123.456789"},
                                   {"time_us", "1700000000123456.789"},
                                   {"time_ns", "1700000000123456789"}}) {
    const auto log =
        read_all(std::string(name) + ",angle_min,angle_step,ranges\n" + text + ",0,1,1\n");
    ASSERT_THAT(log.records, SizeIs(1)) << name;
    EXPECT_EQ(log.records[0].stamp.ns, 1'700'000'000'123'456'789) << name;
  }
  const auto numpy =
      read_all("# stamp angle_min angle_step ranges\n1.5e+00 -1e+00 5e-01 2.5e+00\n");
  ASSERT_THAT(numpy.records, SizeIs(1)) << numpy.error;
  EXPECT_EQ(numpy.records[0].stamp.ns, 1'500'000'000);
  const auto small = read_all("time_ns,angle_min,angle_step,ranges\n-5,0,1,1\n");
  ASSERT_THAT(small.records, SizeIs(1)) << small.error;
  EXPECT_EQ(small.records[0].stamp.ns, -5);
}

// The columns of `rostopic echo -p`.
TEST(CsvLog, WhatRosWritesAsATable) {
  const auto log = read_all(
      "%time,field.header.seq,field.header.stamp,field.header.frame_id,field.angle_min,"
      "field.angle_max,field.angle_increment,field.time_increment,field.scan_time,field.range_min,"
      "field.range_max,field.ranges0,field.ranges1,field.intensities0,field.intensities1\n"
      "5000000001,7,5000000000,laser,-0.5,0.5,1,0.001,0.1,0.1,30,1.5,2.5,100,200\n");
  ASSERT_THAT(log.records, SizeIs(1)) << log.error;
  EXPECT_EQ(log.records[0].stamp.ns, 5'000'000'000);
  EXPECT_EQ(log.records[0].sensor, "laser");
  EXPECT_EQ(log.records[0].scan.time_increment_s, 0.001);
  EXPECT_EQ(log.records[0].scan.scan_time_s, 0.1);
  EXPECT_THAT(log.records[0].scan.ranges_m, ElementsAre(1.5, 2.5));
}

TEST(CsvLog, WhatIsNoNumberInARange) {
  const auto log =
      read_all("stamp,angle_min,angle_step,ranges\n1,0,0.1,,NaN,inf,-inf,\"2.5\",+3,1e-1\n");
  ASSERT_THAT(log.records, SizeIs(1)) << log.error;
  const auto& ranges_m = log.records[0].scan.ranges_m;
  ASSERT_THAT(ranges_m, SizeIs(7));
  EXPECT_TRUE(std::isnan(ranges_m[0]));
  EXPECT_TRUE(std::isnan(ranges_m[1]));
  EXPECT_EQ(ranges_m[2], INFINITY);
  EXPECT_EQ(ranges_m[3], -INFINITY);
  EXPECT_EQ(ranges_m[4], 2.5);
  EXPECT_EQ(ranges_m[5], 3.0);
  EXPECT_EQ(ranges_m[6], 0.1);
}

TEST(CsvLog, DamagedLinesAreCountedWithTheirReason) {
  const std::string header = "stamp,sensor,angle_min,angle_step,odom_x,odom_y,odom_theta,ranges\n";
  const std::string good = "1,a,0,0.1,,,,1,2\n";
  for (const auto& [line, reason] :
       {std::pair{"x,a,0,0.1,,,,1", "the stamp is no number"},
        {"1e30,a,0,0.1,,,,1", "the stamp is no number or out of range"},
        {"1,a,0", "fewer fields"},
        {"1,a,0,0.1,,,", "no ranges"},
        {"1,a,0,0.1,,,,1,z", "a range is no number"},
        {"1,a,q,0.1,,,,1", "a field is no number"},
        {"1,\"a,0,0.1,,,,1", "a quote is not closed"},
        {"1,a,0,0.1,1,2,,1", "odometry is not three finite numbers"},
        {"1,a,0,9,,,,1,2", "angles or limits"},
        {"1,a,,0.1,,,,1,2", "angles or limits"}}) {
    const auto log = read_all(header + good + line + "\n" + good);
    EXPECT_THAT(log.records, SizeIs(2)) << line;
    ASSERT_THAT(log.problems.first, SizeIs(1)) << line;
    EXPECT_EQ(log.problems.first[0].location, "line 3");
    EXPECT_THAT(log.problems.first[0].reason, HasSubstr(reason)) << line;
  }
}

TEST(CsvLog, DecimalCommasAreNamed) {
  EXPECT_THAT(read_all("stamp;angle_min;angle_step;ranges\n1,5;-1,5;0,1;2,5;3\n").error,
              HasSubstr("decimal comma: numbers need a decimal point"));
}

TEST(CsvLog, AMissingColumnIsNamed) {
  EXPECT_EQ(read_all("stamp,angle_min,ranges\n1,2,3\n").error,
            "test.log: table of scans: no column \"angle_step\" or \"angle_step_deg\"");
  EXPECT_THAT(read_all("stamp,angle_min,angle_step,odom_x,ranges\n1,2,3\n").error,
              HasSubstr("odometry needs the columns"));
  EXPECT_THAT(read_all("stamp,angle_min,angle_step,ranges,odom_x\n1,2,3\n").error,
              HasSubstr("\"ranges\" must be the last"));
}

TEST(CsvLog, NumbersThatCannotBeScansAreNotGuessed) {
  for (const char* text : {
           "0.5 1200 7\n1.5 1210 7\n",                       // angle, distance, quality
           "0 1200 1 1210 2 1220\n0 1200 1 1210 2 1220\n",   // revolutions
           "1.0 0.1 0.2 0 0 0 0 1\n2.0 0.3 0.2 0 0 0 0 1\n"  // a trajectory
       }) {
    EXPECT_THAT(read_all(text).error, HasSubstr("rows of numbers")) << text;
    EXPECT_THAT(read_all(text).error, HasSubstr("--layout")) << text;
  }
}

TEST(CsvLog, AHeaderLongerThanOneLook) {
  std::string header = "stamp,angle_min,angle_step";
  std::string row = "1,0,0.0001";
  for (int beam = 0; beam < 20000; ++beam) {
    header += ",range_" + std::to_string(beam);
    row += ",1.5";
  }
  const auto log = read_all(header + ",intensity\n" + row + ",7\n");
  ASSERT_THAT(log.records, SizeIs(1)) << log.error;
  EXPECT_THAT(log.records[0].scan.ranges_m, SizeIs(20000));
}

TEST(CsvWriter, WhatIsWrittenReadsBackBitForBit) {
  auto generator = testing::make_generator();
  std::string table;
  append_csv_header(table);
  std::vector<LogRecord> records;
  for (int i = 0; i < 200; ++i) {
    records.push_back(testing::any_scan(generator));
    append_csv_scan(table, records.back());
  }
  CsvLog log(std::make_unique<InputBuffer>(make_memory_source(table)), "test.csv");
  LogRecord read;
  for (const LogRecord& record : records) {
    ASSERT_TRUE(log.read(read)) << log.problems().first.front().reason;
    EXPECT_EQ(read.sensor, record.sensor);
    EXPECT_EQ(testing::bits_of(read), testing::bits_of(record));
  }
  EXPECT_FALSE(log.read(read));
  EXPECT_TRUE(log.problems().empty());
}

TEST(CsvWriter, RefusesWhatATableCannotHold) {
  auto generator = testing::make_generator();
  const LogRecord good = testing::any_scan(generator);
  std::string table;
  LogRecord record = good;
  record.sensor = "a\nb";
  EXPECT_THROW(append_csv_scan(table, record), ParameterError);
  record = good;
  record.scan.ranges_m.clear();
  EXPECT_THROW(append_csv_scan(table, record), ParameterError);
  record = good;
  record.kind = RecordKind::kOdometry;
  EXPECT_THROW(append_csv_scan(table, record), ParameterError);
}

TEST(CsvLog, CutAnywhereGivesTheScansBeforeAndAWord) {
  const std::string header = "stamp,angle_min,angle_step,odom_x,odom_y,odom_theta,ranges\n";
  const std::string row = "1.25,-1.5,0.5,1,2,0.5,1.25,2.5,inf\n";
  const std::string whole = header + row + row + row;
  const auto expected = read_all(whole);
  ASSERT_THAT(expected.records, SizeIs(3));
  for (std::size_t size = header.size() + row.size(); size < whole.size(); ++size) {
    const auto log = read_all(whole.substr(0, size));
    const std::size_t num_whole = (size - header.size()) / row.size();
    const std::size_t num_cut_bytes = (size - header.size()) % row.size();
    ASSERT_GE(log.records.size(), num_whole) << size;
    for (std::size_t i = 0; i < num_whole; ++i) {
      EXPECT_EQ(testing::bits_of(log.records[i]), testing::bits_of(expected.records[i])) << size;
    }
    // A line that lacks nothing but its end is taken: it has as many ranges as the one before.
    const bool is_complete = log.records.size() > num_whole;
    EXPECT_EQ(is_complete, num_cut_bytes == row.size() - 1) << size;
    EXPECT_EQ(log.problems.empty(), is_complete || num_cut_bytes == 0) << size;
    if (!log.problems.empty()) {
      EXPECT_THAT(log.problems.first[0].reason, HasSubstr("the file ends in this line")) << size;
    }
  }
  for (std::size_t size = 0; size < header.size(); ++size) {
    EXPECT_NE(read_all(whole.substr(0, size)).error, "") << size;
  }
}

}  // namespace setsquare::csv_log_test
