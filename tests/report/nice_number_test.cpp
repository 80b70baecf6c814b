// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/nice_number.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace setsquare::nice_number_test {

TEST(NiceNumber, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(nice_number_below(1.0), 1.0);
  EXPECT_DOUBLE_EQ(nice_number_below(1.99), 1.0);
  EXPECT_DOUBLE_EQ(nice_number_below(4.9), 2.0);
  EXPECT_DOUBLE_EQ(nice_number_below(73.0), 50.0);
  EXPECT_DOUBLE_EQ(nice_number_below(0.03), 0.02);
  EXPECT_DOUBLE_EQ(nice_number_below(1000.0), 1000.0);
}

TEST(NiceTicks, AreRoundWithinTheRangeAndNotTooMany) {
  EXPECT_EQ(nice_ticks(0.0, 10.0, 6), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  for (const double low : {-7.3, 0.0, 1e-4, 12345.6}) {
    for (const double width : {0.013, 1.0, 7.7, 99.0, 4e6}) {
      for (const int max_count : {2, 5, 12}) {
        const std::vector<double> ticks = nice_ticks(low, low + width, max_count);
        EXPECT_LE(static_cast<int>(ticks.size()), max_count);
        for (const double tick : ticks) {
          EXPECT_GE(tick, low - 1e-6 * width);
          EXPECT_LE(tick, low + width * (1.0 + 1e-6));
        }
        if (max_count == 12) {
          EXPECT_GE(ticks.size(), 4U) << low << " + " << width;
        }
      }
    }
  }
}

TEST(DecimalsForStep, DistinguishNeighbours) {
  EXPECT_EQ(decimals_for_step(5.0), 0);
  EXPECT_EQ(decimals_for_step(1.0), 0);
  EXPECT_EQ(decimals_for_step(0.5), 1);
  EXPECT_EQ(decimals_for_step(0.02), 2);
  EXPECT_EQ(decimals_for_step(100.0), 0);
}

}  // namespace setsquare::nice_number_test
