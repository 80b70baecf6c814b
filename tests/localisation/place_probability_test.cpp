// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/place_probability.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "tests/support/seed.hpp"

namespace setsquare::place_probability_test {

TEST(PlaceProbabilities, AreTheSharesOfTheOddsAndLeaveTheRestToElsewhere) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<double> log_odds(static_cast<std::size_t>(trial % 7));
    for (double& value : log_odds) value = testing::uniform(generator, -8.0, 8.0);
    const std::vector<double> probabilities = place_probabilities(log_odds);
    double sum = 1.0;
    for (const double value : log_odds) sum += std::exp(value);
    ASSERT_EQ(probabilities.size(), log_odds.size());
    for (std::size_t i = 0; i < log_odds.size(); ++i) {
      EXPECT_NEAR(probabilities[i], std::exp(log_odds[i]) / sum, 1e-12);
    }
    EXPECT_LT(std::accumulate(probabilities.begin(), probabilities.end(), 0.0), 1.0);
  }
}

TEST(PlaceProbabilities, OfHugeOddsStayNumbers) {
  const std::vector<double> probabilities = place_probabilities(std::vector<double>{900.0, 890.0});
  EXPECT_NEAR(probabilities[0], 1.0 / (1.0 + std::exp(-10.0)), 1e-12);
  EXPECT_NEAR(probabilities[0] + probabilities[1], 1.0, 1e-12);
}

TEST(PlaceRank, GrowsWithWhatAgreesAndFallsWithWhatDoesNot) {
  VerifiedPlace place;
  place.kinds.forward = {.wall_m = 20.0, .loose_m = 10.0};
  place.kinds.backward = {.wall_m = 20.0, .loose_m = 10.0};
  const PlaceFeatures before = place_features(place);
  VerifiedPlace better = place;
  better.fit = 0.5;
  better.score = 0.5;
  better.distinct_wall_m = 5.0;
  EXPECT_GT(place_rank(place_features(better)), place_rank(before));
  EXPECT_GT(presence_log_odds(place_features(better)), presence_log_odds(before));
  VerifiedPlace worse = place;
  worse.kinds.forward.unexplained_m = 5.0;
  worse.kinds.backward.unexplained_m = 5.0;
  EXPECT_LT(place_rank(place_features(worse)), place_rank(before));
  EXPECT_LT(presence_log_odds(place_features(worse)), presence_log_odds(before));
}

}  // namespace setsquare::place_probability_test
