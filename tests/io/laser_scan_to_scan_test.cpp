// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/laser_scan_to_scan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/io/ros/echo_choice.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::laser_scan_to_scan_test {

using ros::LaserScan;
using ros::scan_from_laser_scan;
using ros::ScanConversion;
using ros::ScanOddities;
using ros::ScanOddity;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

LaserScan message(double first_rad, double last_rad, double step_rad, std::size_t num_beams) {
  LaserScan scan;
  scan.stamp = {1'000'000'000};
  scan.angle_min_rad = first_rad;
  scan.angle_max_rad = last_rad;
  scan.angle_increment_rad = step_rad;
  scan.range_min_m = 0.1;
  scan.range_max_m = 10.0;
  scan.ranges_m.assign(num_beams, 2.0);
  return scan;
}

ScanOddities only(ScanOddity oddity) {
  ScanOddities oddities;
  oddities.add(oddity);
  return oddities;
}

/// The scan of a message that must be one, and its oddities.
struct Converted {
  Scan scan;
  ScanOddities oddities;
};
Converted convert(LaserScan message) {
  Converted converted;
  const ScanConversion conversion = scan_from_laser_scan(std::move(message), converted.scan);
  EXPECT_THAT(conversion.fault, IsEmpty());
  EXPECT_NO_THROW(converted.scan.validate());
  converted.oddities = conversion.oddities;
  return converted;
}

TEST(ScanFromLaserScan, AnOrdinaryScan) {
  LaserScan laser = message(-1.5, 1.5, 0.5, 7);
  laser.time_increment_s = 1e-4;
  laser.scan_time_s = 0.1;
  const auto [scan, oddities] = convert(laser);
  EXPECT_TRUE(oddities.empty());
  EXPECT_EQ(scan.stamp, laser.stamp);
  EXPECT_EQ(scan.num_beams(), 7U);
  EXPECT_EQ(scan.first_bearing_rad, -1.5);
  EXPECT_EQ(scan.bearing_step_rad, 0.5);
  EXPECT_EQ(scan.min_range_m, 0.1);
  EXPECT_EQ(scan.max_range_m, 10.0);
  EXPECT_EQ(scan.time_increment_s, 1e-4);
  EXPECT_EQ(scan.scan_time_s, 0.1);
}

TEST(ScanFromLaserScan, Rep117IsWhatScanJudges) {
  LaserScan laser = message(-1.5, 1.5, 0.5, 7);
  laser.ranges_m = {-kInfinity, kInfinity, kNan, 0.0, 0.05, 2.0, 10.0};
  const Scan scan = convert(laser).scan;
  EXPECT_EQ(scan.outcome(0), BeamOutcome::kInvalid);
  EXPECT_EQ(scan.outcome(1), BeamOutcome::kNoReturn);
  EXPECT_EQ(scan.outcome(2), BeamOutcome::kInvalid);
  EXPECT_EQ(scan.outcome(3), BeamOutcome::kInvalid);
  EXPECT_EQ(scan.outcome(4), BeamOutcome::kInvalid);
  EXPECT_EQ(scan.outcome(5), BeamOutcome::kReturn);
  EXPECT_EQ(scan.outcome(6), BeamOutcome::kNoReturn);
}

TEST(ScanFromLaserScan, AnAngleMaxThatDoesNotFitLoses) {
  const double degree_rad = rad_from_deg(1.0);
  const auto off_by_one = convert(message(0.0, kTwoPi, degree_rad, 360));
  EXPECT_EQ(off_by_one.oddities, only(ScanOddity::kAngleMaxOneBeamOff));
  EXPECT_EQ(off_by_one.scan.bearing_step_rad, degree_rad);
  EXPECT_EQ(off_by_one.scan.num_beams(), 360U);
  // 64 beams all around, and angles of 270 degrees.
  const auto off = convert(message(-1.3046, 3.4078, kTwoPi / 64.0, 64));
  EXPECT_EQ(off.oddities, only(ScanOddity::kAngleMaxOff));
  EXPECT_EQ(off.scan.num_beams(), 64U);
  EXPECT_EQ(convert(message(-1.0, kNan, 0.1, 5)).oddities, only(ScanOddity::kAngleMaxOff));
}

TEST(ScanFromLaserScan, ALastBeamThatRepeatsTheFirstIsLeftOut) {
  for (const double sign : {1.0, -1.0}) {
    const auto full = convert(message(-sign * kPi, sign * kPi, sign * rad_from_deg(1.0), 361));
    EXPECT_TRUE(full.oddities.has(ScanOddity::kRepeatedBeam));
    EXPECT_EQ(full.scan.num_beams(), 360U);
  }
  // Angles as single precision and three digits give them.
  const auto rounded = convert(message(0.0, 6.28, 0.017493, 360));
  EXPECT_EQ(rounded.oddities, only(ScanOddity::kRepeatedBeam));
  EXPECT_EQ(rounded.scan.num_beams(), 359U);
}

TEST(ScanFromLaserScan, AStepOfZeroIsTakenFromTheAngles) {
  const auto mended = convert(message(-1.0, 1.0, 0.0, 5));
  EXPECT_EQ(mended.oddities, only(ScanOddity::kNoIncrement));
  EXPECT_EQ(mended.scan.bearing_step_rad, 0.5);
  Scan scan;
  EXPECT_THAT(scan_from_laser_scan(message(0.0, 0.0, 0.0, 5), scan).fault, HasSubstr("no step"));
  EXPECT_THAT(scan_from_laser_scan(message(0.0, kNan, kNan, 5), scan).fault, HasSubstr("no step"));
  EXPECT_THAT(scan_from_laser_scan(message(0.0, 100.0, 0.0, 5), scan).fault, HasSubstr("no step"));
}

TEST(ScanFromLaserScan, ClockwiseScansAreTakenAsTheyRun) {
  const auto clockwise = convert(message(1.0, -1.0, -0.5, 5));
  EXPECT_EQ(clockwise.oddities, only(ScanOddity::kClockwise));
  EXPECT_EQ(clockwise.scan.first_bearing_rad, 1.0);
  EXPECT_EQ(clockwise.scan.bearing_step_rad, -0.5);
}

TEST(ScanFromLaserScan, MoreThanOneTurnIsMendedByAnglesOfOneTurnOrRefused) {
  const auto mended = convert(message(-kPi, kPi - kTwoPi / 400, 0.02, 400));
  EXPECT_TRUE(mended.oddities.has(ScanOddity::kMoreThanOneTurn));
  EXPECT_NEAR(mended.scan.bearing_step_rad, kTwoPi / 400, 1e-12);
  EXPECT_EQ(mended.scan.num_beams(), 400U);
  Scan scan;
  const auto refused = scan_from_laser_scan(message(-180.0, 180.0, 1.0, 361), scan);
  EXPECT_THAT(refused.fault, HasSubstr("more than one turn"));
  EXPECT_TRUE(refused.oddities.has(ScanOddity::kMoreThanOneTurn));
  EXPECT_THAT(scan_from_laser_scan(message(0.0, 8.0, 8.0, 2), scan).fault, HasSubstr("one turn"));
}

TEST(ScanFromLaserScan, RangeLimitsThatMakeNoSenseAreLeftAside) {
  LaserScan laser = message(-1.0, 1.0, 0.5, 5);
  for (const double none : {0.0, -1.0, kNan}) {
    laser.range_max_m = none;
    const auto [scan, oddities] = convert(laser);
    EXPECT_EQ(oddities, only(ScanOddity::kNoRangeMax));
    EXPECT_EQ(scan.max_range_m, kInfinity);
    EXPECT_EQ(scan.min_range_m, 0.1);
  }
  laser.range_max_m = 0.05;
  EXPECT_EQ(convert(laser).oddities, only(ScanOddity::kRangeLimitsReversed));
  EXPECT_EQ(convert(laser).scan.outcome(0), BeamOutcome::kReturn);
  laser.range_max_m = 10.0;
  laser.range_min_m = kNan;
  EXPECT_EQ(convert(laser).oddities, only(ScanOddity::kNoRangeMin));
  laser.range_min_m = 0.1;
  laser.range_max_m = 1.5;
  EXPECT_EQ(convert(laser).oddities, only(ScanOddity::kRangesBeyondMax));
  laser.ranges_m.assign(5, kInfinity);
  EXPECT_TRUE(convert(laser).oddities.empty());
  laser.ranges_m.assign(5, static_cast<double>(1.5F));
  EXPECT_TRUE(convert(laser).oddities.empty());
}

TEST(ScanFromLaserScan, OneRangeAboveTheMaximumIsFoundWhereverItIs) {
  for (std::size_t num_beams = 2; num_beams < 20; ++num_beams) {
    for (std::size_t odd = 0; odd < num_beams; ++odd) {
      LaserScan laser = message(0.0, 0.1 * static_cast<double>(num_beams - 1), 0.1, num_beams);
      for (const double nothing : {kNan, kInfinity, -kInfinity, 10.0}) {
        laser.ranges_m[odd] = nothing;
        EXPECT_TRUE(convert(laser).oddities.empty()) << num_beams << ' ' << odd;
      }
      laser.ranges_m[odd] = 10.1;
      EXPECT_EQ(convert(laser).oddities, only(ScanOddity::kRangesBeyondMax));
    }
  }
}

TEST(ScanFromLaserScan, ASweepThatNoScannerTakesIsNone) {
  LaserScan laser = message(-1.0, 1.0, 0.5, 5);
  laser.time_increment_s = 2.4;
  laser.scan_time_s = 9.6;
  EXPECT_TRUE(convert(laser).oddities.empty());
  EXPECT_EQ(convert(laser).scan.time_increment_s, 2.4);
  for (const double absurd_s : {2.6, 1e30}) {
    laser.time_increment_s = absurd_s;
    EXPECT_EQ(convert(laser).oddities, only(ScanOddity::kEndlessSweep));
    EXPECT_EQ(convert(laser).scan.time_increment_s, 0.0);
  }
}

TEST(ScanFromLaserScan, WhatIsNoScanIsRefused) {
  Scan scan;
  EXPECT_TRUE(
      scan_from_laser_scan(message(0.0, 1.0, 0.1, 0), scan).oddities.has(ScanOddity::kNoBeams));
  EXPECT_THAT(scan_from_laser_scan(message(0.0, 1.0, 1e-6, 100'000), scan).fault,
              HasSubstr("too many"));
  EXPECT_TRUE(
      scan_from_laser_scan(message(kNan, 1.0, 0.1, 5), scan).oddities.has(ScanOddity::kNoAngles));
  EXPECT_TRUE(
      scan_from_laser_scan(message(1e30, 1e30, 0.1, 5), scan).oddities.has(ScanOddity::kNoAngles));
  LaserScan no_stamp = message(-1.0, 1.0, 0.5, 5);
  no_stamp.stamp = {};
  EXPECT_EQ(convert(no_stamp).oddities, only(ScanOddity::kNoStamp));
  LaserScan one_beam = message(0.5, 0.5, 0.0, 1);
  EXPECT_TRUE(convert(one_beam).oddities.empty());
}

TEST(ScanFromLaserScan, WhateverTheNumbersAreTheScanIsValidOrRefused) {
  auto generator = testing::make_generator();
  const std::array<double, 12> numbers = {
      0.0, -0.0, 1e-300, 0.01, 0.017453293, 1.0, kPi, kTwoPi, 1e300, kInfinity, -kInfinity, kNan};
  const auto any = [&] {
    const double number = numbers[generator() % numbers.size()];
    return generator() % 2 == 0 ? number : -number;
  };
  const std::array<std::size_t, 6> counts = {1, 2, 3, 64, 360, 361};
  int num_taken = 0;
  for (int round = 0; round < 20'000; ++round) {
    LaserScan laser = message(any(), any(), any(), counts[generator() % counts.size()]);
    laser.range_min_m = any();
    laser.range_max_m = any();
    laser.time_increment_s = any();
    Scan scan;
    const auto conversion = scan_from_laser_scan(std::move(laser), scan);
    if (!conversion.fault.empty()) continue;
    ++num_taken;
    ASSERT_NO_THROW(scan.validate()) << testing::test_seed();
  }
  EXPECT_GT(num_taken, 2'000);
}

TEST(ScanFromLaserScan, EveryOddityHasWords) {
  for (std::size_t i = 0; i < ros::kNumScanOddities; ++i) {
    EXPECT_FALSE(describe(static_cast<ScanOddity>(i)).what.empty()) << i;
    EXPECT_FALSE(describe(static_cast<ScanOddity>(i)).remedy.empty()) << i;
  }
}

/// A sequence of float64 in memory, as a message would hold it.
ros::NumberArray array_of(const std::vector<double>& values) {
  return {{reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)},
          ros::Primitive::kFloat64,
          false};
}

TEST(EchoChoice, TheFirstOrTheStrongestOfEachBeam) {
  const std::vector<double> two_m = {1.0, 2.0};
  const std::vector<double> three_m = {4.0, 5.0, 6.0};
  const std::vector<double> two = {10.0, 20.0};
  const std::vector<double> three = {30.0, 20.0, 10.0};
  ros::MultiEchoLaserScan scan;
  scan.echoes_m = {array_of(two_m), array_of({}), array_of(three_m)};
  scan.intensities = {array_of(two), array_of({}), array_of(three)};
  ros::choose_echoes(scan, ros::EchoChoice::kFirst);
  ASSERT_EQ(scan.ranges_m.size(), 3U);
  EXPECT_EQ(scan.ranges_m[0], 1.0);
  EXPECT_TRUE(std::isnan(scan.ranges_m[1]));
  EXPECT_EQ(scan.ranges_m[2], 4.0);
  ros::choose_echoes(scan, ros::EchoChoice::kStrongest);
  EXPECT_EQ(scan.ranges_m[0], 2.0);
  EXPECT_EQ(scan.ranges_m[2], 4.0);
  scan.intensities.clear();
  ros::choose_echoes(scan, ros::EchoChoice::kStrongest);
  EXPECT_EQ(scan.ranges_m[0], 1.0);
  scan.intensities = {array_of({}), array_of({}), array_of({})};
  ros::choose_echoes(scan, ros::EchoChoice::kStrongest);
  EXPECT_EQ(scan.ranges_m[0], 1.0);
}

}  // namespace setsquare::laser_scan_to_scan_test
