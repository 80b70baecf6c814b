// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/sort_by.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "tests/support/seed.hpp"

namespace setsquare::sort_by_test {

struct Named {
  int number = 0;
  std::string name;

  friend bool operator==(const Named&, const Named&) = default;
};

/// Many of the same number.
std::vector<Named> random_values() {
  auto generator = testing::make_generator();
  std::uniform_int_distribution<int> number(-5, 5);
  std::vector<Named> values(200);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = {number(generator), "value " + std::to_string(i)};
  }
  return values;
}

TEST(SortBy, IsTheStableSortOfTheStandardLibrary) {
  std::vector<Named> values = random_values();
  std::vector<Named> twin = values;
  sort_by(values, &Named::number);
  std::ranges::stable_sort(twin, {}, &Named::number);
  EXPECT_EQ(values, twin);
}

TEST(SortBy, GreatestFirstIsTheStableSortOfTheStandardLibrary) {
  std::vector<Named> values = random_values();
  std::vector<Named> twin = values;
  sort_by_greatest(values, [](const Named& value) { return value.number; });
  std::ranges::stable_sort(twin, std::ranges::greater{}, &Named::number);
  EXPECT_EQ(values, twin);
}

TEST(SortBy, NothingStaysNothing) {
  std::vector<Named> values;
  sort_by(values, &Named::number);
  EXPECT_TRUE(values.empty());
}

}  // namespace setsquare::sort_by_test
