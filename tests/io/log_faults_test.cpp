// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "setsquare/io/logs/carmen/writer.hpp"
#include "setsquare/io/logs/faults/find_faults.hpp"
#include "tests/io/read_all.hpp"
#include "tests/support/seed.hpp"
#include "tests/support/simulated_drive.hpp"

namespace setsquare::log_faults_test {

using ::testing::Contains;
using testing::drive;
using testing::Fan;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::l_shaped_room;
using testing::scans_on_drive;
using testing::way_around_the_room;

const Fan kFan = {
    .num_beams = 361, .first_bearing_rad = -0.5 * kPi, .bearing_step_rad = rad_from_deg(0.5)};

/// The way around a room, odometry without errors.
std::vector<LogRecord> healthy_records(const Fan& fan = kFan) {
  const std::vector<Pose2> truth = drive(way_around_the_room());
  const std::vector<Scan> scans = scans_on_drive(l_shaped_room(), truth, 0.01, fan);
  std::vector<LogRecord> records(scans.size());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    records[i].sensor = "laser";
    records[i].scan = scans[i];
    records[i].stamp = scans[i].stamp;
    records[i].T_odom_base = truth[i];
    records[i].position = i + 1;
  }
  return records;
}

std::vector<LogFinding> faults_of(const std::vector<LogRecord>& records) {
  LogSurvey survey;
  for (const LogRecord& record : records) survey.add(record);
  return find_faults(survey, {});
}

using Spoil = std::function<void(LogRecord&, std::mt19937_64&)>;

std::vector<LogRecord> spoilt(const Spoil& spoil, const Fan& fan = kFan) {
  auto generator = testing::make_generator();
  std::vector<LogRecord> records = healthy_records(fan);
  for (LogRecord& record : records) spoil(record, generator);
  return records;
}

Spoil each_range(const std::function<double(double, std::mt19937_64&)>& change) {
  return [change](LogRecord& record, std::mt19937_64& generator) {
    for (double& range_m : record.scan.ranges_m) range_m = change(range_m, generator);
  };
}

Spoil stamps_times(double factor) {
  return [factor](LogRecord& record, std::mt19937_64&) {
    record.stamp.ns = static_cast<std::int64_t>(static_cast<double>(record.stamp.ns) * factor);
    record.scan.stamp = record.stamp;
  };
}

bool happens(double probability, std::mt19937_64& generator) {
  return testing::uniform(generator, 0.0, 1.0) < probability;
}

/// The only finding, of that kind and with that option.
void expect_only(const std::vector<LogFinding>& found,
                 FindingKind kind,
                 const std::string& option) {
  ASSERT_EQ(found.size(), 1U) << (found.empty() ? "" : text_of(found.back()));
  EXPECT_EQ(found[0].kind, kind) << found[0].sentence;
  EXPECT_EQ(found[0].option, option) << found[0].sentence;
  EXPECT_THAT(found[0].sentence, HasSubstr("laser: "));
}

TEST(LogFaults, NothingIsFoundInAHealthyLog) {
  for (const Fan& fan : {kFan,
                         Fan{},
                         Fan{.num_beams = 360, .first_bearing_rad = -kPi},
                         Fan{.num_beams = 1081,
                         .first_bearing_rad = rad_from_deg(-135.0),
                         .bearing_step_rad = rad_from_deg(0.25)}}) {
    const auto found = faults_of(healthy_records(fan));
    EXPECT_THAT(found, IsEmpty()) << text_of(found.front());
  }
}

TEST(LogFaults, RangesInAnotherUnit) {
  const auto times = [](double factor) {
    return each_range([factor](double range_m, std::mt19937_64&) { return factor * range_m; });
  };
  expect_only(faults_of(spoilt(times(1000.0))), FindingKind::kRangeUnit, "--range-scale 0.001");
  expect_only(faults_of(spoilt(times(100.0))), FindingKind::kRangeUnit, "--range-scale 0.01");
}

TEST(LogFaults, ErrorCodesOfAFewMillimetres) {
  const auto codes = each_range([](double range_m, std::mt19937_64& generator) {
    return happens(0.02, generator) ? 0.001 * std::round(testing::uniform(generator, 1.0, 19.0))
                                    : range_m;
  });
  const auto found = faults_of(spoilt(codes));
  expect_only(found, FindingKind::kErrorCodes, "");
  EXPECT_NEAR(found.at(0).share.value_or(0.0), 0.02, 0.005);
}

TEST(LogFaults, ACodeAmongTheReturns) {
  const auto reach = each_range([](double range_m, std::mt19937_64& generator) {
    return range_m > 4.0 || happens(0.02, generator) ? 4.095 : range_m;
  });
  const auto at_reach = faults_of(spoilt(reach));
  ASSERT_FALSE(at_reach.empty());
  EXPECT_EQ(at_reach[0].option, "--max-range 4.095");
  const auto amid = each_range([](double range_m, std::mt19937_64& generator) {
    return happens(0.03, generator) ? 0.7 : range_m;
  });
  const auto found = faults_of(spoilt(amid));
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].option, "--ignore-range 0.7");
}

TEST(LogFaults, ReturnsThatStandAlone) {
  const auto dust = each_range([](double range_m, std::mt19937_64& generator) {
    return happens(0.05, generator) ? range_m * testing::uniform(generator, 0.1, 0.7) : range_m;
  });
  expect_only(faults_of(spoilt(dust)), FindingKind::kIsolatedReturns, "");
}

TEST(LogFaults, PostsOfTheRobotItself) {
  const Spoil posts = [](LogRecord& record, std::mt19937_64& generator) {
    for (std::size_t beam = 40; beam < 52; ++beam) {
      record.scan.ranges_m[beam] = testing::uniform(generator, 0.29, 0.31);
    }
  };
  expect_only(faults_of(spoilt(posts)), FindingKind::kRobotParts, "");
}

TEST(LogFaults, TooFewBeams) {
  for (const std::size_t num_beams : {8U, 16U, 24U}) {
    const Fan fan = {.num_beams = num_beams,
                     .first_bearing_rad = -kPi,
                     .bearing_step_rad = kTwoPi / static_cast<double>(num_beams)};
    const auto found = faults_of(healthy_records(fan));
    expect_only(found, FindingKind::kFewBeams, "");
    EXPECT_THAT(found.at(0).sentence, HasSubstr(std::to_string(num_beams) + " beams"));
  }
}

TEST(LogFaults, MirroredScans) {
  const auto mirror = [](LogRecord& record, std::mt19937_64&) {
    std::ranges::reverse(record.scan.ranges_m);
  };
  expect_only(faults_of(spoilt(mirror)), FindingKind::kMirrored, "--mirror-scans");
}

// A whole turn or less, a little more or fewer beams each time, read as half a turn.
TEST(LogFaults, AWiderFieldOfViewThanAssumed) {
  for (const double field_deg : {240.0, 270.0, 360.0}) {
    const Fan fan = {.num_beams = 361,
                     .first_bearing_rad = -0.5 * rad_from_deg(field_deg),
                     .bearing_step_rad = rad_from_deg(field_deg) / 360.0};
    const auto squeeze = [](LogRecord& record, std::mt19937_64& generator) {
      record.has_assumed_bearings = true;
      if (happens(0.5, generator)) record.scan.ranges_m.pop_back();
      record.scan.first_bearing_rad = -0.5 * kPi;
      record.scan.bearing_step_rad = kPi / static_cast<double>(record.scan.num_beams());
    };
    const auto found = faults_of(spoilt(squeeze, fan));
    const auto is_named = [&](const LogFinding& finding) {
      return finding.option == "--field-of-view " + std::to_string(static_cast<int>(field_deg));
    };
    EXPECT_TRUE(std::ranges::any_of(found, is_named)) << field_deg;
  }
}

TEST(LogFaults, OdometryThatNeverMoves) {
  const auto stop = [](LogRecord& record, std::mt19937_64&) { record.T_odom_base = Pose2{}; };
  expect_only(faults_of(spoilt(stop)), FindingKind::kOdometryConstant, "--no-odometry");
}

// A robot that stands, and sees the same.
TEST(LogFaults, OdometryAtRestIsOdometry) {
  const std::vector<Pose2> standing(100, Pose2{1.0, 1.0, 0.3});
  const auto scans = scans_on_drive(l_shaped_room(), standing, 0.01, kFan);
  std::vector<LogRecord> records(scans.size());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    records[i].sensor = "laser";
    records[i].scan = scans[i];
    records[i].stamp = scans[i].stamp;
    records[i].T_odom_base = standing[i];
  }
  EXPECT_THAT(faults_of(records), IsEmpty());
}

TEST(LogFaults, AScannerThatHangs) {
  std::vector<LogRecord> records = healthy_records();
  const std::vector<double> last = records[20].scan.ranges_m;
  for (std::size_t i = 20; i < records.size(); ++i) records[i].scan.ranges_m = last;
  const auto found = faults_of(records);
  const auto is_repeat = [](const LogFinding& finding) {
    return finding.kind == FindingKind::kScansRepeated && finding.share > 0.8;
  };
  EXPECT_TRUE(std::ranges::any_of(found, is_repeat));
}

TEST(LogFaults, StampsInAFinerUnit) {
  expect_only(faults_of(spoilt(stamps_times(1e3))), FindingKind::kStampUnit, "--stamp-unit ms");
  expect_only(faults_of(spoilt(stamps_times(1e6))), FindingKind::kStampUnit, "--stamp-unit us");
  const auto without_odometry = [](LogRecord& record, std::mt19937_64& generator) {
    stamps_times(1e3)(record, generator);
    record.T_odom_base.reset();
  };
  expect_only(faults_of(spoilt(without_odometry)), FindingKind::kStampUnit, "--stamp-unit ms");
}

TEST(LogFaults, ManyJumpsOfTheOdometry) {
  const auto in_cm = [](LogRecord& record, std::mt19937_64&) {
    record.T_odom_base->x_m *= 100.0;
    record.T_odom_base->y_m *= 100.0;
  };
  expect_only(faults_of(spoilt(in_cm)), FindingKind::kOdometryJumps, "--no-odometry");
}

TEST(LogFaults, WhatTheReaderRemarkedComesLast) {
  LogProblems problems;
  problems.remarks.push_back("the gzip stream ends early");
  problems.add("line 7", "no numbers");
  const auto found = find_faults({}, problems);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].kind, FindingKind::kRemark);
  EXPECT_THAT(found[1].sentence, HasSubstr("line 7"));
}

/// A log in text of spoilt records.
std::string carmen_log(const std::vector<LogRecord>& records) {
  std::string text;
  for (const LogRecord& record : records) {
    Scan scan = record.scan;
    scan.max_range_m = 9e4;  // what no range reaches, in millimetres neither
    append_carmen_scan(text, scan, {*record.T_odom_base});
  }
  return text;
}

// What each option mends is a healthy log again.
TEST(LogFaults, TheOptionsMend) {
  struct Mended {
    Spoil spoil;
    std::function<void(LogOptions&)> use;
  };
  const std::vector<Mended> cases = {
      {each_range([](double range_m, std::mt19937_64&) { return 1000.0 * range_m; }),
       [](LogOptions& options) { options.range_scale = 0.001; }},
      {[](LogRecord& record, std::mt19937_64&) { std::ranges::reverse(record.scan.ranges_m); },
       [](LogOptions& options) { options.mirrors_scans = true; }},
      {stamps_times(1e3),
       [](LogOptions& options) { options.stamp_unit = StampUnit::kMilliseconds; }},
      {each_range([](double range_m, std::mt19937_64& generator) {
         return range_m > 6.9 || happens(0.02, generator) ? 7.0 : range_m;
       }),
       [](LogOptions& options) { options.max_range_m = 6.9995; }}};
  for (const Mended& mended : cases) {
    const std::string text = carmen_log(spoilt(mended.spoil));
    EXPECT_FALSE(faults_of(testing::read_all(text).records).empty());
    LogOptions options;
    mended.use(options);
    const auto found = faults_of(testing::read_all(text, options).records);
    EXPECT_THAT(found, IsEmpty()) << text_of(found.front());
  }
}

}  // namespace setsquare::log_faults_test
