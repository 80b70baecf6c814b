// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/angle.hpp"

#include <gtest/gtest.h>

#include "tests/support/seed.hpp"

namespace setsquare::angle_test {

TEST(Angle, DegreesAndRadiansAreInverse) {
  EXPECT_DOUBLE_EQ(rad_from_deg(180.0), kPi);
  EXPECT_DOUBLE_EQ(deg_from_rad(-0.5 * kPi), -90.0);
}

TEST(Angle, WrapsIntoTheHalfOpenInterval) {
  EXPECT_EQ(wrap_to_pi(kPi), -kPi);
  EXPECT_EQ(wrap_to_pi(-kPi), -kPi);
  EXPECT_EQ(wrap_to_pi(0.0), 0.0);
  EXPECT_NEAR(wrap_to_pi(1.5 * kPi), -0.5 * kPi, 1e-15);
  EXPECT_NEAR(wrap_to_pi(-7.0), -7.0 + kTwoPi, 1e-15);
  EXPECT_LT(wrap_to_pi(std::nextafter(kPi, 0.0)), kPi);
}

TEST(Angle, WrappingKeepsTheAngleModuloThePeriod) {
  std::mt19937_64 generator = testing::make_generator();
  for (int i = 0; i < 1000; ++i) {
    const double angle_rad = testing::uniform(generator, -100.0, 100.0);
    const double period_rad = testing::uniform(generator, 0.1, 7.0);
    const double wrapped_rad = wrap_to_period(angle_rad, period_rad);
    EXPECT_GE(wrapped_rad, -0.5 * period_rad);
    EXPECT_LT(wrapped_rad, 0.5 * period_rad);
    const double turns = (angle_rad - wrapped_rad) / period_rad;
    EXPECT_NEAR(turns, std::round(turns), 1e-9);
  }
}

}  // namespace setsquare::angle_test
