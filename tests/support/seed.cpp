// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/seed.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

namespace setsquare::testing {

std::uint64_t test_seed() {
  static const std::uint64_t seed = [] {
    const char* text = std::getenv("SETSQUARE_TEST_SEED");
    return text != nullptr ? std::strtoull(text, nullptr, 10) : std::uint64_t{20141018};
  }();
  return seed;
}

std::mt19937_64 make_generator() {
  std::cout << "seed " << test_seed() << " (set SETSQUARE_TEST_SEED to change it)\n";
  return std::mt19937_64(test_seed());
}

}  // namespace setsquare::testing
