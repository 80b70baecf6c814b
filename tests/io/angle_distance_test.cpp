// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "setsquare/core/angle.hpp"
#include "setsquare/io/logs/angle_distance/log.hpp"
#include "tests/io/random_records.hpp"
#include "tests/io/read_all.hpp"

namespace setsquare::angle_distance_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::read_all;
using ::testing::SizeIs;
using Layout = AngleDistanceOptions::Layout;

LogOptions rows(const AngleDistanceOptions& meaning) {
  LogOptions options;
  options.angle_distance = meaning;
  return options;
}

/// Three revolutions of `num_beams` beams, distances in mm: 1000 mm plus the degree.
std::string pairs(int num_beams, double first_deg, double step_deg) {
  std::string text;
  for (int revolution = 0; revolution < 3; ++revolution) {
    for (int beam = 0; beam < num_beams; ++beam) {
      const double angle_deg = first_deg + beam * step_deg;
      text += std::to_string(angle_deg) + " " + std::to_string(1000.0 + angle_deg) + " 15\n";
    }
  }
  return text;
}

void expect_circle(const Scan& scan, std::size_t num_beams) {
  ASSERT_EQ(scan.num_beams(), num_beams);
  for (std::size_t beam = 0; beam < num_beams; ++beam) {
    double angle_deg = deg_from_rad(scan.bearing_rad(beam));
    angle_deg += angle_deg < -1e-6 ? 360.0 : 0.0;
    EXPECT_NEAR(scan.ranges_m[beam], 1.0 + 0.001 * std::fmod(angle_deg, 360.0), 1e-6) << beam;
  }
}

TEST(AngleDistance, ARevolutionEndsWhereTheAngleWraps) {
  const auto log = read_all(pairs(360, 0.0, 1.0), rows({.rate_hz = 5.0}));
  ASSERT_THAT(log.records, SizeIs(3)) << log.error;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(log.records[i].stamp.ns, static_cast<std::int64_t>(i) * 200'000'000);
    EXPECT_EQ(log.records[i].scan.scan_time_s, 0.2);
    EXPECT_NEAR(log.records[i].scan.bearing_step_rad, rad_from_deg(1.0), 1e-9);
    expect_circle(log.records[i].scan, 360);
  }
}

TEST(AngleDistance, FallingAnglesNarrowSweepsAndFewBeamsWrapToo) {
  EXPECT_THAT(read_all(pairs(360, 359.0, -1.0), rows({})).records, SizeIs(3));
  EXPECT_THAT(read_all(pairs(60, -30.0, 1.0), rows({})).records, SizeIs(3));
  EXPECT_THAT(read_all(pairs(8, 0.0, 45.0), rows({})).records, SizeIs(3));
  EXPECT_THAT(read_all(pairs(8, 315.0, -45.0), rows({})).records, SizeIs(3));
}

TEST(AngleDistance, RplidarsOwnText) {
  std::string text = "Ultra simple LIDAR data grabber\nVersion: 1.2.3\n";
  for (int revolution = 0; revolution < 2; ++revolution) {
    text += "S  theta: 0.50 Dist: 01000.00 Q: 47 \n";
    for (int degree = 1; degree < 360; ++degree) {
      text += "   theta: " + std::to_string(degree) + ".50 Dist: 02000.00 Q: 47 \n";
    }
  }
  AngleDistanceOptions meaning;
  meaning.is_clockwise = true;
  const auto log = read_all(text, rows(meaning));
  ASSERT_THAT(log.records, SizeIs(2)) << log.error;
  EXPECT_TRUE(log.problems.empty());
  const Scan& scan = log.records[0].scan;
  ASSERT_EQ(scan.num_beams(), 360U);
  for (std::size_t beam = 0; beam < 360; ++beam) {
    const bool is_first = std::abs(deg_from_rad(wrap_to_pi(scan.bearing_rad(beam))) + 0.5) < 0.4;
    EXPECT_EQ(scan.ranges_m[beam], is_first ? 1.0 : 2.0) << beam;
  }
}

TEST(AngleDistance, OneLinePerRevolution) {
  AngleDistanceOptions meaning;
  meaning.layout = Layout::kRevolutions;
  meaning.is_in_degrees = false;
  meaning.range_unit_m = 1.0;
  for (const char* text : {"0,1 0.1,2 0.2,inf 0.3,4\n", "0;1;0.1;2;0.2;inf;0.3;4\n"}) {
    const auto log = read_all(text, rows(meaning));
    ASSERT_THAT(log.records, SizeIs(1)) << log.error;
    EXPECT_NEAR(log.records[0].scan.first_bearing_rad, 0.0, 1e-12);
    EXPECT_NEAR(log.records[0].scan.bearing_step_rad, 0.1, 1e-12);
    EXPECT_THAT(log.records[0].scan.ranges_m, ElementsAre(1.0, 2.0, INFINITY, 4.0));
  }
  EXPECT_THAT(read_all("0,1 0.1,2\n0,1 0.1\n", rows(meaning)).problems.first[0].reason,
              HasSubstr("an angle without its distance"));
}

TEST(AngleDistance, MillimetresAreExact) {
  const auto log = read_all("0 1234\n1 1001\n2 0\n", rows({}));
  ASSERT_THAT(log.records, SizeIs(1));
  EXPECT_EQ(log.records[0].scan.ranges_m[0], 1.234);
  EXPECT_EQ(log.records[0].scan.ranges_m[1], 1.001);
  EXPECT_TRUE(std::isnan(log.records[0].scan.ranges_m[2]));  // 0 is no return
}

// Twin of resample(): each beam asks every pair.
double nearest_return(const std::vector<BearingRange>& beams, const Scan& scan, std::size_t beam) {
  double nearest_m = NAN;
  for (const BearingRange& pair : beams) {
    double off_rad = wrap_to_pi(pair.bearing_rad - scan.bearing_rad(beam));
    if (std::abs(off_rad) > 0.5 * scan.bearing_step_rad || !(pair.range_m > 0.0)) continue;
    nearest_m = std::fmin(nearest_m, pair.range_m);
  }
  return nearest_m;
}

TEST(Resample, IsTheNearestReturnOfEachBeam) {
  auto generator = testing::make_generator();
  for (int round = 0; round < 200; ++round) {
    std::vector<BearingRange> beams;
    const auto num_pairs = 2 + generator() % 400;
    const double sweep_rad = testing::uniform(generator, 0.1, kTwoPi);
    const double turn_rad = testing::uniform(generator, -kPi, kPi);
    for (std::uint64_t i = 0; i < num_pairs; ++i) {
      const double jitter = testing::uniform(generator, -0.4, 0.4);
      const double share = (static_cast<double>(i) + jitter) / static_cast<double>(num_pairs);
      beams.push_back({wrap_to_pi(turn_rad + share * sweep_rad), testing::any_range(generator)});
    }
    Scan scan;
    auto sorted = beams;
    ASSERT_TRUE(resample(sorted, scan));
    scan.validate();
    for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
      EXPECT_EQ(testing::bits_of(scan.ranges_m[beam]),
                testing::bits_of(nearest_return(beams, scan, beam)));
    }
  }
}

TEST(Resample, NeedsTwoBearings) {
  Scan scan;
  std::vector<BearingRange> none;
  EXPECT_FALSE(resample(none, scan));
  std::vector<BearingRange> same = {{1.0, 2.0}, {1.0, 3.0}};
  EXPECT_FALSE(resample(same, scan));
  std::vector<BearingRange> around_pi = {{3.1, 2.0}, {-3.1, 3.0}};
  ASSERT_TRUE(resample(around_pi, scan));
  EXPECT_THAT(scan.ranges_m, ElementsAre(2.0, 3.0));
  EXPECT_NEAR(scan.bearing_step_rad, kTwoPi - 6.2, 1e-12);
}

TEST(AngleDistance, OptionsAndDamageAreTold) {
  LogOptions options = rows({});
  options.angle_distance->range_unit_m = 0.0;
  EXPECT_THAT(read_all("1 2\n", options).error, HasSubstr("range_unit_m"));
  options = rows({});
  options.angle_distance->rate_hz = 0.0;
  EXPECT_THAT(read_all("1 2\n", options).error, HasSubstr("rate_hz"));
  const auto log = read_all("0 1000\n1 1000\nhello\n1 2 3 4\n1e9 1\n2 1000", rows({}));
  EXPECT_THAT(log.records, SizeIs(1));
  ASSERT_EQ(log.problems.num_damaged, 3U);
  EXPECT_EQ(log.problems.first[0].location, "line 3");
  EXPECT_THAT(log.problems.first[0].reason, HasSubstr("no row of angle and distance"));
  EXPECT_THAT(log.problems.first[1].reason, HasSubstr("expected angle, distance"));
  EXPECT_THAT(log.problems.first[2].reason, HasSubstr("not an angle"));
}

TEST(AngleDistance, CutAnywhereGivesTheRevolutionsBefore) {
  const std::string whole = pairs(8, 0.0, 45.0);
  const auto expected = read_all(whole, rows({}));
  for (std::size_t size = 20; size < whole.size(); ++size) {
    const auto log = read_all(whole.substr(0, size), rows({}));
    for (std::size_t i = 0; i + 1 < log.records.size(); ++i) {
      EXPECT_EQ(testing::bits_of(log.records[i]), testing::bits_of(expected.records[i])) << size;
    }
  }
}

}  // namespace setsquare::angle_distance_test
