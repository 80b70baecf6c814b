// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Fast turns with scanners that take the whole time from scan to scan for a sweep.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/tracking/scan_tracker.hpp"
#include "setsquare/tracking/sweep_trial.hpp"
#include "tests/support/spin.hpp"

namespace setsquare::turn_on_the_spot_test {

using testing::scans_of_spin;
using testing::Spin;
using testing::SpunScan;

/// How far off the heading is after the turn, at rest, in deg.
double heading_error_deg(const std::vector<SpunScan>& scans,
                         bool has_odometry,
                         const ScanTrackerParams& params = {}) {
  ScanTracker tracker(params);
  double tracked_rad = 0.0;
  for (const SpunScan& spun : scans) {
    const std::optional<Pose2> wheels =
        has_odometry ? std::optional<Pose2>(spun.T_wheels_base) : std::nullopt;
    tracked_rad = tracker.track(spun.scan, wheels).T_odom_sensor.theta_rad;
  }
  return std::abs(deg_from_rad(wrap_to_pi(tracked_rad - scans.back().turn_rad)));
}

struct Case {
  double rate_hz;
  double turn_deg_per_s;
};
constexpr Case kCases[] = {{7, 90}, {7, 180}, {7, 250}, {10, 90}, {10, 180}, {10, 250}};

TEST(TurnOnTheSpot, TheHeadingIsBack) {
  for (const Case& c : kCases) {
    for (const bool has_odometry : {false, true}) {
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const auto scans = scans_of_spin({c.rate_hz, c.turn_deg_per_s}, seed);
        EXPECT_LT(heading_error_deg(scans, has_odometry), 0.5)
            << c.rate_hz << " Hz, " << c.turn_deg_per_s << " deg/s, seed " << seed;
      }
    }
  }
}

TEST(TurnOnTheSpot, TheHeadingIsBackWithAScannerThatSpinsTheOtherWay) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto scans = scans_of_spin({.turn_deg_per_s = 180.0, .sweep_share = -1.0}, seed);
    EXPECT_LT(heading_error_deg(scans, false), 0.5) << seed;
  }
}

/// What deskewing is for, switched off.
TEST(TurnOnTheSpot, WithoutDeskewingATurnIsLostInPart) {
  ScanTrackerParams skewed;
  skewed.deskew.is_on = false;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto scans = scans_of_spin({.turn_deg_per_s = 90.0}, seed);
    EXPECT_GT(heading_error_deg(scans, true, skewed), 5.0) << seed;
  }
}

/// What the search for sudden turns is for, switched off: at 250 deg/s the first scan of a turn
/// fits nowhere. The votes of keyframes, which may find it as well, are switched off in both.
TEST(TurnOnTheSpot, ASuddenFastTurnIsFound) {
  ScanTrackerParams searching;
  searching.long_steps.num_steps = 1;
  searching.long_steps.min_long = 2;
  ScanTrackerParams expecting = searching;
  expecting.deskew.sudden_turn.below_score = -2.0;
  int num_wrong = 0;
  int num_wrong_without = 0;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    const auto scans = scans_of_spin({.turn_deg_per_s = 250.0}, seed);
    num_wrong += heading_error_deg(scans, false, searching) > 0.5;
    num_wrong_without += heading_error_deg(scans, false, expecting) > 0.5;
  }
  EXPECT_EQ(num_wrong, 0);
  EXPECT_GE(num_wrong_without, 1);
}

TEST(TurnOnTheSpot, ScansThatSayNothingOfTheirSweepAreLeftAsTheyAre) {
  ScanTracker tracker;
  for (const SpunScan& spun : scans_of_spin({.states_sweep = false}, 1)) {
    (void)tracker.track(spun.scan, std::nullopt);
    EXPECT_FALSE(tracker.deskewed_scan().has_value());
    EXPECT_TRUE(tracker.sweep_motion().is_rest());
  }
}

std::optional<double> sweep_found(const std::vector<SpunScan>& scans) {
  SweepTrial trial{ScanTrackerParams{}};
  for (const SpunScan& spun : scans) trial.add(spun.scan, std::nullopt);
  return trial.sweep_s();
}

TEST(SweepTrial, FindsTheSweepAndItsWayAround) {
  for (const Case& c : kCases) {
    for (const double share : {-1.0, 1.0}) {
      const Spin spin{c.rate_hz, c.turn_deg_per_s, 1.0, share, false};
      const std::optional<double> found_s = sweep_found(scans_of_spin(spin, 4));
      ASSERT_TRUE(found_s.has_value()) << c.turn_deg_per_s;
      EXPECT_NEAR(*found_s, share * 359.0 / 360.0 / c.rate_hz, 1e-6) << c.turn_deg_per_s;
    }
  }
}

// A driver that sends each scan twice halves the time from scan to scan, not that of a sweep.
TEST(SweepTrial, FindsTheSweepWhereEachScanIsSentTwice) {
  const Spin spin{.rate_hz = 7.0, .turn_deg_per_s = 180.0, .states_sweep = false};
  const auto found_s = [&](bool exact) {
    std::vector<SpunScan> twice;
    for (const SpunScan& spun : scans_of_spin(spin, 4)) {
      twice.insert(twice.end(), 2, spun);
      twice.back().scan.stamp.ns += 70'000'000;
      if (!exact) twice.back().scan.ranges_m.front() += 1e-9;
    }
    return sweep_found(twice);
  };
  ASSERT_TRUE(found_s(true).has_value());
  EXPECT_NEAR(*found_s(true), 359.0 / 360.0 / spin.rate_hz, 1e-6);
  EXPECT_NE(found_s(false), found_s(true)) << "without the rule";
}

TEST(SweepTrial, SaysWhereAllBeamsAreMeasuredAtOnce) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Spin spin{.turn_deg_per_s = 180.0, .sweep_share = 0.0, .states_sweep = false};
    const std::optional<double> found_s = sweep_found(scans_of_spin(spin, seed));
    ASSERT_TRUE(found_s.has_value()) << seed;
    EXPECT_EQ(*found_s, 0.0) << seed;
  }
}

TEST(SweepTrial, StaysOpenWhereTheRobotDoesNotTurn) {
  const Spin spin{.num_turns = 0.0, .states_sweep = false};
  EXPECT_FALSE(sweep_found(scans_of_spin(spin, 1)).has_value());
}

TEST(SweepTrial, StaysOpenWhereScansAreFarApart) {
  const Spin spin{.rate_hz = 2.0, .states_sweep = false};
  EXPECT_FALSE(sweep_found(scans_of_spin(spin, 1)).has_value());
}

}  // namespace setsquare::turn_on_the_spot_test
