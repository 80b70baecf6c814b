// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/text_scanner.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "tests/support/seed.hpp"

namespace setsquare::text_scanner_test {

// The short-decimal path must give exactly the double that strtod gives.
TEST(TextScanner, NumbersEqualStrtodBitForBit) {
  auto generator = testing::make_generator();
  for (int i = 0; i < 20000; ++i) {
    char text[64];
    const double value = testing::uniform(generator, -1.0, 1.0) *
                         std::pow(10.0, testing::uniform(generator, -8.0, 12.0));
    const int num_decimals = static_cast<int>(testing::uniform(generator, 0.0, 14.0));
    std::snprintf(text, sizeof text, "%.*f", num_decimals, value);
    const auto number = TextScanner(text).number();
    ASSERT_TRUE(number) << text;
    ASSERT_EQ(*number, std::strtod(text, nullptr)) << text;
  }
}

TEST(TextScanner, OtherFormsOfNumbers) {
  for (const char* text : {"0",
                           "-0.5",
                           "007",
                           "5.",
                           "1e3",
                           "1.25e-3",
                           "123456789012345678.5",
                           "0.1234567890123456789"}) {
    const auto number = TextScanner(text).number();
    ASSERT_TRUE(number) << text;
    EXPECT_EQ(*number, std::strtod(text, nullptr)) << text;
  }
  EXPECT_TRUE(std::isnan(*TextScanner("nan").number()));
  EXPECT_TRUE(std::isinf(*TextScanner("inf").number()));
}

TEST(TextScanner, WhatIsNoNumber) {
  for (const char* text : {"", " ", "-", ".", "1.2.3", "1,5", "abc", "12x", "0x10", "--1", "+ 1"}) {
    EXPECT_FALSE(TextScanner(text).number()) << text;
  }
  EXPECT_FALSE(TextScanner("nan").finite_number());
  EXPECT_FALSE(TextScanner("1e400").finite_number());
}

TEST(TextScanner, CountsWordsAndPosesInARow) {
  TextScanner text("  FLASER\t2 1.5 -2.5 0.25 end \r");
  EXPECT_EQ(text.word(), "FLASER");
  EXPECT_EQ(text.count(), 2U);
  EXPECT_EQ(text.pose(), (Pose2{1.5, -2.5, 0.25}));
  EXPECT_FALSE(text.is_at_end());
  EXPECT_EQ(text.word(), "end");
  EXPECT_TRUE(text.is_at_end());
  EXPECT_FALSE(text.word());
}

TEST(TextScanner, CountsAreWholeAndFit) {
  EXPECT_FALSE(TextScanner("-1").count());
  EXPECT_FALSE(TextScanner("1.5").count());
  EXPECT_FALSE(TextScanner("99999999999").count());
}

}  // namespace setsquare::text_scanner_test
