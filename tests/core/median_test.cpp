// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/median.hpp"

#include <gtest/gtest.h>

namespace setsquare::median_test {

TEST(Median, IsTheMiddleOne) {
  EXPECT_EQ(median({5.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(upper_median({5.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median({7.0}), 7.0);
}

TEST(Median, OfAnEvenNumberIsTheMiddleTwosMeanOrTheUpperOne) {
  EXPECT_EQ(median({4.0, 1.0, 2.0, 9.0}), 3.0);
  EXPECT_EQ(upper_median({4.0, 1.0, 2.0, 9.0}), 4.0);
}

}  // namespace setsquare::median_test
