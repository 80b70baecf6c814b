// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/paper/zncc.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/seed.hpp"

namespace setsquare::zncc_test {

/// The textbook's two passes.
double zncc_in_two_passes(const std::vector<std::int32_t>& a, const std::vector<std::int32_t>& b) {
  const auto n = static_cast<double>(a.size());
  double mean_a = 0.0, mean_b = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    mean_a += a[k] / n;
    mean_b += b[k] / n;
  }
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    ab += (a[k] - mean_a) * (b[k] - mean_b);
    aa += (a[k] - mean_a) * (a[k] - mean_a);
    bb += (b[k] - mean_b) * (b[k] - mean_b);
  }
  return ab / std::sqrt(aa * bb);
}

std::vector<std::int32_t> random_counts(std::mt19937_64& generator, std::size_t size) {
  std::vector<std::int32_t> counts(size);
  for (std::int32_t& count : counts) {
    count = static_cast<std::int32_t>(testing::uniform(generator, 0.0, 30.0));
  }
  return counts;
}

TEST(Zncc, EqualsItsPlainTwinAndStaysWithinOne) {
  std::mt19937_64 generator = testing::make_generator();
  for (const std::size_t size : {10, 100, 500}) {
    for (int i = 0; i < 20; ++i) {
      const auto a = random_counts(generator, size);
      const auto b = random_counts(generator, size);
      const double value = zncc(a, b);
      EXPECT_NEAR(value, zncc_in_two_passes(a, b), 1e-12);
      EXPECT_LE(std::abs(value), 1.0);
      EXPECT_EQ(value, zncc(b, a));
    }
  }
}

TEST(Zncc, DoesNotFeelGainAndOffset) {
  std::mt19937_64 generator = testing::make_generator();
  const auto a = random_counts(generator, 200);
  const auto b = random_counts(generator, 200);
  auto changed = b;
  for (std::int32_t& count : changed) count = 7 * count + 40;
  EXPECT_NEAR(zncc(a, changed), zncc(a, b), 1e-12);
  for (std::int32_t& count : changed) count = -count;
  EXPECT_NEAR(zncc(a, changed), -zncc(a, b), 1e-12);
}

TEST(Zncc, IsOneOfEqualAndMinusOneOfOppositeProfiles) {
  const std::vector<std::int32_t> a = {0, 3, 1, 9};
  const std::vector<std::int32_t> opposite = {9, 6, 8, 0};
  EXPECT_DOUBLE_EQ(zncc(a, a), 1.0);
  EXPECT_DOUBLE_EQ(zncc(a, opposite), -1.0);
}

TEST(Zncc, IsZeroWhereAProfileIsFlat) {
  const std::vector<std::int32_t> flat = {4, 4, 4};
  const std::vector<std::int32_t> peak = {0, 1, 0};
  EXPECT_EQ(zncc(flat, peak), 0.0);
  EXPECT_EQ(zncc(peak, flat), 0.0);
  EXPECT_EQ(zncc({}, {}), 0.0);
}

}  // namespace setsquare::zncc_test
