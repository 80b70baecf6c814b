// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/bootstrap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/eval/error_statistics.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::bootstrap_test {

/// Values about 5 of deviation 1, each like the last one by so much (an autoregressive process).
std::vector<double> alike(std::mt19937_64& generator, std::size_t num, double likeness) {
  std::normal_distribution<double> normal;
  std::vector<double> values(num);
  double value = normal(generator);
  for (double& next : values) {
    value = likeness * value + std::sqrt(1.0 - likeness * likeness) * normal(generator);
    next = 5.0 + value;
  }
  return values;
}

/// In what share of 150 sets the true mean lies within the bounds of the mean.
double coverage(double likeness, std::size_t block_length) {
  auto generator = testing::make_generator();
  int num_within = 0;
  constexpr int kNumSets = 150;
  for (int set = 0; set < kNumSets; ++set) {
    const auto values = alike(generator, 400, likeness);
    const ErrorBounds bounds =
        bootstrap_bounds(values, {.num_resamples = 100, .block_length = block_length});
    if (bounds.mean.low <= 5.0 && 5.0 <= bounds.mean.high) ++num_within;
  }
  return static_cast<double>(num_within) / kNumSets;
}

TEST(Bootstrap, NineOfTenBoundsHoldTheTruth) {
  EXPECT_NEAR(coverage(0.0, 0), 0.9, 0.07);
  EXPECT_GT(coverage(0.5, 0), 0.78);
}

// 400 values that are so alike tell as much as some 20 independent ones: blocks give bounds that
// are a little too narrow (77 % hold the truth), single values far too narrow ones (28 %).
TEST(Bootstrap, BlocksMatterWhereNeighboursAreAlike) {
  EXPECT_GT(coverage(0.9, 0), 0.7);
  EXPECT_LT(coverage(0.9, 1), 0.5);
}

TEST(Bootstrap, BlocksGrowWithTheLikenessOfNeighbours) {
  auto generator = testing::make_generator();
  EXPECT_LE(block_length_of(alike(generator, 2000, 0.0)), 6U);
  const std::size_t of_half = block_length_of(alike(generator, 2000, 0.5));
  const std::size_t of_most = block_length_of(alike(generator, 2000, 0.95));
  EXPECT_GT(of_half, 3U);
  EXPECT_GT(of_most, 2 * of_half);
  EXPECT_LE(of_most, 3 * 44U);
}

TEST(Bootstrap, TheSameSeedGivesTheSameBoundsAndAnotherOthers) {
  auto generator = testing::make_generator();
  const auto values = alike(generator, 300, 0.8);
  const ErrorBounds first = bootstrap_bounds(values);
  const ErrorBounds again = bootstrap_bounds(values);
  const ErrorBounds other = bootstrap_bounds(values, {.seed = 2});
  EXPECT_EQ(first.mean.low, again.mean.low);
  EXPECT_EQ(first.median.high, again.median.high);
  EXPECT_NE(first.mean.low, other.mean.low);
  EXPECT_NEAR(first.mean.low, other.mean.low, 0.2 * (first.mean.high - first.mean.low));
}

TEST(Bootstrap, BoundsLieAboutEachStatistic) {
  auto generator = testing::make_generator();
  for (int run = 0; run < 20; ++run) {
    const auto values = alike(generator, 200, testing::uniform(generator, 0.0, 0.9));
    const ErrorStatistics statistics = error_statistics(values, BootstrapParams{});
    ASSERT_TRUE(statistics.bounds);
    EXPECT_LT(statistics.bounds->mean.low, statistics.mean);
    EXPECT_GT(statistics.bounds->mean.high, statistics.mean);
    EXPECT_LT(statistics.bounds->rmse.low, statistics.rmse);
    EXPECT_GT(statistics.bounds->rmse.high, statistics.rmse);
    EXPECT_LE(statistics.bounds->median.low, statistics.median);
    EXPECT_GE(statistics.bounds->median.high, statistics.median);
    EXPECT_LT(statistics.bounds->deviation.low, statistics.bounds->deviation.high);
    EXPECT_GE(statistics.bounds->mean.low, *std::min_element(values.begin(), values.end()));
    EXPECT_LE(statistics.bounds->mean.high, *std::max_element(values.begin(), values.end()));
  }
}

// A block of all values is the set itself, turned: no statistic changes.
TEST(Bootstrap, OneBlockOfEverythingVariesNothing) {
  auto generator = testing::make_generator();
  const auto values = alike(generator, 50, 0.5);
  const ErrorStatistics statistics = error_statistics(values);
  for (const std::size_t length : {50U, 500U}) {
    const ErrorBounds bounds = bootstrap_bounds(values, {.block_length = length});
    EXPECT_EQ(bounds.block_length, 50U);
    EXPECT_NEAR(bounds.mean.low, statistics.mean, 1e-12);
    EXPECT_NEAR(bounds.rmse.high, statistics.rmse, 1e-12);
    EXPECT_EQ(bounds.median.low, statistics.median);
    EXPECT_NEAR(bounds.deviation.high, statistics.deviation, 1e-12);
  }
}

TEST(Bootstrap, FewOrEqualErrorsAreNoTrouble) {
  for (const std::vector<double>& values :
       {std::vector<double>{2.0}, std::vector<double>{2.0, 2.0}, std::vector<double>(100, 2.0)}) {
    const ErrorBounds bounds = bootstrap_bounds(values);
    EXPECT_EQ(bounds.mean.low, 2.0);
    EXPECT_EQ(bounds.mean.high, 2.0);
    EXPECT_EQ(bounds.deviation.high, 0.0);
  }
  EXPECT_FALSE(error_statistics({}, BootstrapParams{}).bounds);
  EXPECT_THROW(static_cast<void>(bootstrap_bounds(std::vector<double>{1.0}, {.num_resamples = 19})),
               ParameterError);
}

}  // namespace setsquare::bootstrap_test
