// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/joined.hpp"

#include <gtest/gtest.h>

#include <array>

namespace setsquare::joined_test {

TEST(Joined, ASeparatorStandsBetweenWordsOnly) {
  EXPECT_EQ(joined({}), "");
  EXPECT_EQ(joined(std::array<std::string, 1>{"a"}), "a");
  EXPECT_EQ(joined(std::array<std::string, 3>{"a", "b", "c"}), "a, b, c");
  EXPECT_EQ(joined(std::array<std::string, 3>{"", "b", ""}, "|"), "|b|");
}

}  // namespace setsquare::joined_test
