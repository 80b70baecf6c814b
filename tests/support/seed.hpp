// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>

namespace setsquare::testing {

/// A generator for a property test. Its seed is fixed, printed when a test fails, and overridden by
/// the environment variable SETSQUARE_TEST_SEED.
[[nodiscard]] std::mt19937_64 make_generator();

/// The seed that make_generator uses.
[[nodiscard]] std::uint64_t test_seed();

[[nodiscard]] inline double uniform(std::mt19937_64& generator, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(generator);
}

}  // namespace setsquare::testing
