// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/gyro.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::gyro_test {

using testing::make_generator;

constexpr double kSample_s = 0.01;
constexpr double kScan_s = 0.1;

/// A robot that stands, and turns left and right, 120 deg at a time.
double heading_rad(double time_s) {
  const double phase_s = std::fmod(time_s, 4.0);
  if (phase_s < 1.0) return 0.0;
  return rad_from_deg(60.0) * (1.0 - std::cos(kTwoPi * (phase_s - 1.0) / 3.0));
}

double true_rate_rad_per_s(double time_s) {
  return (heading_rad(time_s + 1e-6) - heading_rad(time_s - 1e-6)) / 2e-6;
}

Timestamp stamp_at(double time_s) { return {std::llround(1e9 * time_s)}; }

/// A gyro that has gone with the robot for a time; `shown`: its rate for a true one. Matched turns
/// have noise of 0.2 deg at either end, and one in ten is wrong.
Gyro gyro_after(double duration_s, const std::function<double(double)>& shown) {
  auto generator = make_generator();
  std::normal_distribution<double> noise(0.0, 1.0);
  Gyro gyro{GyroParams{}};
  double last_matched_rad = 0.0;
  int num_samples = 0;
  for (int scan = 0; scan * kScan_s < duration_s; ++scan) {
    const double time_s = scan * kScan_s;
    for (; num_samples * kSample_s <= time_s; ++num_samples) {
      const double sample_s = num_samples * kSample_s;
      gyro.add(stamp_at(sample_s), shown(true_rate_rad_per_s(sample_s)));
    }
    double matched_rad = heading_rad(time_s) + rad_from_deg(0.2) * noise(generator);
    if (scan % 10 == 9) matched_rad += rad_from_deg(15.0) * noise(generator);
    if (scan > 0) {
      gyro.compare(stamp_at(time_s - kScan_s), stamp_at(time_s), matched_rad - last_matched_rad);
    }
    last_matched_rad = matched_rad;
  }
  return gyro;
}

TEST(Gyro, IsBelievedAfterSomeTurnsAndFindsItsBias) {
  for (const double bias_rad_per_s : {0.0, rad_from_deg(0.5), rad_from_deg(-3.0)}) {
    const Gyro gyro = gyro_after(60.0, [&](double rate) { return rate + bias_rad_per_s; });
    EXPECT_EQ(gyro.report().verdict, GyroVerdict::kBelieved);
    EXPECT_NEAR(gyro.report().bias_rad_per_s, bias_rad_per_s, rad_from_deg(0.15));
    EXPECT_NEAR(gyro.report().scale, 1.0, 0.03);
    const auto turn_rad = gyro.turn_rad(stamp_at(58.3), stamp_at(58.6));
    ASSERT_TRUE(turn_rad);
    EXPECT_NEAR(*turn_rad, heading_rad(58.6) - heading_rad(58.3), rad_from_deg(0.8));
  }
}

TEST(Gyro, IsNotBelievedBeforeTheRobotHasTurned) {
  const Gyro gyro = gyro_after(1.0, [](double rate) { return rate; });
  EXPECT_EQ(gyro.report().verdict, GyroVerdict::kOpen);
  EXPECT_FALSE(gyro.turn_rad(stamp_at(0.3), stamp_at(0.4)));
}

TEST(Gyro, OneThatLiesIsToldAndIgnored) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::mt19937_64 generator(7);
  std::normal_distribution<double> noise(0.0, 1.0);
  struct Lie {
    std::function<double(double)> shown;
    GyroVerdict verdict;
  };
  const std::vector<Lie> lies = {
      {[](double rate) { return -rate; }, GyroVerdict::kMirrored},
      {[](double rate) { return deg_from_rad(rate); }, GyroVerdict::kDegrees},
      {[](double) { return 0.0; }, GyroVerdict::kUnlike},
      {[](double) { return 1.3; }, GyroVerdict::kUnlike},
      {[&](double) { return noise(generator); }, GyroVerdict::kUnlike},
      {[](double rate) { return 3.0 * rate; }, GyroVerdict::kUnlike},
      {[&](double) { return nan; }, GyroVerdict::kOpen}};
  for (std::size_t i = 0; i < lies.size(); ++i) {
    const Gyro gyro = gyro_after(60.0, lies[i].shown);
    EXPECT_EQ(gyro.report().verdict, lies[i].verdict) << i;
    EXPECT_FALSE(gyro.turn_rad(stamp_at(58.3), stamp_at(58.6))) << i;
  }
}

/// A scanner that is carried: it swings to and fro faster than the half second of a comparison, and
/// rests now and then.
double carried_heading_rad(double time_s) {
  const double phase_s = std::fmod(time_s, 7.0);
  if (phase_s > 5.0) return 0.0;
  return rad_from_deg(35.0) * std::sin(kTwoPi * phase_s / 1.25) * std::sin(kPi * phase_s / 5.0);
}

/// One that is swung as evenly as a pendulum: half a swing later all looks mirrored.
double pendulum_heading_rad(double time_s) {
  return rad_from_deg(30.0) * std::sin(kTwoPi * time_s / 0.8);
}

using Heading = double (*)(double time_s);

/// How the gyro of a carried scanner is judged whose scans are stamped late.
GyroReport carried_report(std::uint64_t seed,
                          double scans_late_s,
                          const std::function<double(double)>& shown,
                          Heading heading = carried_heading_rad,
                          double duration_s = 60.0) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> noise(0.0, 1.0);
  Gyro gyro{GyroParams{}};
  double last_matched_rad = 0.0;
  int num_samples = 0;
  for (int scan = 1; scan * kScan_s < duration_s; ++scan) {
    const double time_s = scan * kScan_s;
    for (; num_samples * kSample_s <= time_s; ++num_samples) {
      const double sample_s = num_samples * kSample_s;
      const double rate = (heading(sample_s + 1e-6) - heading(sample_s - 1e-6)) / 2e-6;
      gyro.add(stamp_at(sample_s), shown(rate) * (1.0 + 0.02 * noise(generator)));
    }
    double matched_rad = heading(time_s - scans_late_s) + rad_from_deg(0.3) * noise(generator);
    if (scan % 10 == 9) matched_rad += rad_from_deg(15.0) * noise(generator);
    if (scan > 1) {
      gyro.compare(stamp_at(time_s - kScan_s), stamp_at(time_s), matched_rad - last_matched_rad);
    }
    last_matched_rad = matched_rad;
  }
  return gyro.report();
}

// Where scans are stamped when they arrive: found at another time of the gyro, what it is is told.
TEST(Gyro, WhatItIsIsToldWhereScansAreStampedLateOrEarly) {
  struct Kind {
    double scale;  ///< Of what the gyro shows.
    GyroVerdict verdict;
  };
  const std::vector<Kind> kinds = {{1.0, GyroVerdict::kOffTime},
                                   {-1.0, GyroVerdict::kMirrored},
                                   {deg_from_rad(1.0), GyroVerdict::kDegrees},
                                   {-deg_from_rad(1.0), GyroVerdict::kDegrees}};
  for (const std::uint64_t seed : {101U, 102U, 103U}) {
    for (const Kind& kind : kinds) {
      for (const double late_s : {-0.22, -0.15, 0.13, 0.2}) {
        const GyroReport report = carried_report(
            seed, late_s, [&](double rate) { return kind.scale * rate + 0.01 * kind.scale; });
        EXPECT_EQ(report.verdict, kind.verdict) << seed << ' ' << kind.scale << ' ' << late_s;
        EXPECT_NEAR(report.scale * kind.scale, 1.0, 0.15) << late_s;
        EXPECT_NEAR(report.scans_late_s, late_s, 0.051);
      }
    }
  }
}

TEST(Gyro, OneThatFitsAtNoTimeOrAtOnceIsToldSo) {
  for (const std::uint64_t seed : {201U, 202U, 203U, 204U, 205U}) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> noise(0.0, 1.0);
    const std::vector<std::function<double(double)>> unlike = {
        [&](double) { return noise(generator); },
        [&](double) { return std::exp(noise(generator)); },
        [](double) { return 1.3; },
        [](double rate) { return 3.0 * rate; }};
    for (std::size_t i = 0; i < unlike.size(); ++i) {
      EXPECT_EQ(carried_report(seed, 0.1, unlike[i]).verdict, GyroVerdict::kUnlike) << i;
    }
    const GyroReport right = carried_report(seed, 0.0, [](double rate) { return rate; });
    EXPECT_EQ(right.verdict, GyroVerdict::kBelieved);
    EXPECT_EQ(right.scans_late_s, 0.0);
  }
}

TEST(Gyro, WhichWayAPendulumTurnsIsNotGuessed) {
  for (const std::uint64_t seed : {301U, 302U, 303U}) {
    for (const double late_s : {-0.2, -0.1, 0.1, 0.15, 0.2}) {
      const auto verdict = carried_report(
                               seed, late_s, [](double rate) { return rate; }, pendulum_heading_rad)
                               .verdict;
      EXPECT_NE(verdict, GyroVerdict::kMirrored) << seed << ' ' << late_s;
    }
  }
}

TEST(Gyro, SaysNothingOfTimesThatItDoesNotSpan) {
  const Gyro gyro = gyro_after(60.0, [](double rate) { return rate; });
  EXPECT_FALSE(gyro.turn_rad(stamp_at(20.0), stamp_at(20.1))) << "long forgotten";
  EXPECT_FALSE(gyro.turn_rad(stamp_at(59.0), stamp_at(61.0))) << "to come";
  EXPECT_TRUE(gyro.turn_rad(stamp_at(59.0), stamp_at(59.95)));
}

TEST(Gyro, AGapOrAClockSetBackBeginsAnew) {
  Gyro gyro = gyro_after(60.0, [](double rate) { return rate; });
  gyro.add(stamp_at(70.0), 0.0);
  gyro.add(stamp_at(70.01), 0.0);
  EXPECT_FALSE(gyro.turn_rad(stamp_at(59.0), stamp_at(70.0)));
  EXPECT_TRUE(gyro.turn_rad(stamp_at(70.0), stamp_at(70.01)));
  gyro.add(stamp_at(10.0), 0.0);
  gyro.add(stamp_at(10.01), 0.0);
  EXPECT_TRUE(gyro.turn_rad(stamp_at(10.0), stamp_at(10.01)));
}

}  // namespace setsquare::gyro_test
