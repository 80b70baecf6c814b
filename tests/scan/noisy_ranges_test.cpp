// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/scan/noisy_ranges.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "setsquare/core/angle.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::noisy_ranges_test {

/// Ranges in the middle of a square room of 8 m, one degree apart, all around.
Scan in_square_room(double noise_m, std::uint64_t seed) {
  Scan scan;
  scan.first_bearing_rad = -kPi;
  scan.bearing_step_rad = rad_from_deg(1.0);
  scan.max_range_m = 30.0;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0.0, 1.0);
  for (int beam = 0; beam < 360; ++beam) {
    const double bearing_rad = scan.first_bearing_rad + beam * scan.bearing_step_rad;
    const double exact_m =
        4.0 / std::max(std::abs(std::cos(bearing_rad)), std::abs(std::sin(bearing_rad)));
    scan.ranges_m.push_back(exact_m + noise_m * noise(random));
  }
  return scan;
}

double rms_error_m(const std::vector<double>& ranges_m) {
  const Scan exact = in_square_room(0.0, 0);
  double sum_m2 = 0.0;
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    sum_m2 += (ranges_m[i] - exact.ranges_m[i]) * (ranges_m[i] - exact.ranges_m[i]);
  }
  return std::sqrt(sum_m2 / static_cast<double>(ranges_m.size()));
}

TEST(NoisyRanges, TheirDeviationIsFound) {
  constexpr int kNumScans = 20;  // One alone is off by a fifth.
  for (const double noise_m : {0.05, 0.1, 0.2}) {
    double sum_m = 0.0;
    for (int i = 0; i < kNumScans; ++i) {
      sum_m += range_noise_m(in_square_room(noise_m, testing::test_seed() + i));
    }
    EXPECT_NEAR(sum_m / kNumScans, noise_m, 0.2 * noise_m);
  }
}

TEST(NoisyRanges, AreSmoothedToHalfTheirNoise) {
  const Scan scan = in_square_room(0.2, testing::test_seed());
  const auto smoothed_m = smoothed_ranges_m(scan);
  ASSERT_TRUE(smoothed_m.has_value());
  EXPECT_LT(rms_error_m(*smoothed_m), 0.5 * rms_error_m(scan.ranges_m));
}

TEST(NoisyRanges, UsualScannersAreLeftAlone) {
  EXPECT_FALSE(smoothed_ranges_m(in_square_room(0.02, testing::test_seed())).has_value());
  EXPECT_FALSE(smoothed_ranges_m(Scan{}).has_value());
}

TEST(NoisyRanges, ClutterIsNoNoise) {
  Scan scan = in_square_room(0.01, testing::test_seed());
  std::mt19937_64 random(testing::test_seed());
  std::uniform_real_distribution<double> range_m(0.5, 6.0);
  for (std::size_t i = 0; i < scan.num_beams(); i += 6) scan.ranges_m[i] = range_m(random);
  EXPECT_FALSE(smoothed_ranges_m(scan).has_value());
}

TEST(NoisyRanges, WhatIsNoReturnStays) {
  Scan scan = in_square_room(0.2, testing::test_seed());
  scan.ranges_m[17] = 0.0;
  scan.ranges_m[90] = 81.83;
  const auto smoothed_m = smoothed_ranges_m(scan);
  ASSERT_TRUE(smoothed_m.has_value());
  EXPECT_EQ((*smoothed_m)[17], 0.0);
  EXPECT_EQ((*smoothed_m)[90], 81.83);
}

TEST(NoisyRanges, AStepFromThingToThingStays) {
  Scan scan = in_square_room(0.15, testing::test_seed());
  for (std::size_t i = 100; i < 130; ++i) scan.ranges_m[i] -= 3.0;
  const auto smoothed_m = smoothed_ranges_m(scan);
  ASSERT_TRUE(smoothed_m.has_value());
  EXPECT_NEAR((*smoothed_m)[100], scan.ranges_m[100], 0.5);
  EXPECT_NEAR((*smoothed_m)[99], scan.ranges_m[99], 0.5);
}

}  // namespace setsquare::noisy_ranges_test
