// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/place_probability.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

#include "setsquare/localisation/localisation_params.hpp"
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

/// Places 10 m apart that differ in fit alone.
std::vector<VerifiedPlace> places_of_fits(const std::vector<double>& fits) {
  std::vector<VerifiedPlace> places(fits.size());
  for (std::size_t i = 0; i < fits.size(); ++i) {
    places[i].T_grid_sensor.x_m = 10.0 * static_cast<double>(i);
    places[i].fit = fits[i];
    places[i].unjudged_share = 0.0;
  }
  return places;
}

TEST(PlaceStanding, IsHowFarTheBestRanksAboveTheSecondAndTheNextFive) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<double> fits(static_cast<std::size_t>(2 + trial % 9));
    for (double& fit : fits) fit = testing::uniform(generator, -1.0, 1.0);
    const std::vector<VerifiedPlace> places = places_of_fits(fits);
    std::vector<double> ranks;
    for (const VerifiedPlace& place : places) ranks.push_back(place_rank(place_features(place)));
    std::ranges::sort(ranks, std::ranges::greater{});
    double sum = 0.0;
    std::size_t num = 0;
    for (std::size_t i = 1; i < ranks.size() && i <= 5; ++i, ++num) {
      sum += std::min(PlaceStanding::kMost, ranks[0] - ranks[i]);
    }
    const PlaceStanding standing = place_standing(places);
    EXPECT_NEAR(standing.above_second, std::min(PlaceStanding::kMost, ranks[0] - ranks[1]), 1e-9);
    EXPECT_NEAR(standing.above_others, sum / static_cast<double>(num), 1e-9);
  }
}

TEST(PlaceStanding, OfOnePlaceIsTheFarthestWhereverItWasFoundTwice) {
  std::vector<VerifiedPlace> places = places_of_fits({0.5, 0.45});
  places[1].T_grid_sensor = places[0].T_grid_sensor;
  EXPECT_EQ(place_standing(places).above_second, PlaceStanding::kMost);
  EXPECT_EQ(place_standing(places).above_others, PlaceStanding::kMost);
}

TEST(PresenceLogOdds, GrowWithTheStandingAmongThePlacesOfTheWholeMap) {
  // The same best place: chance finds many that are as good, a right one is alone.
  const auto presence = [](const std::vector<double>& fits) {
    return place_scale(places_of_fits(fits), true).presence;
  };
  EXPECT_GT(presence({0.6, 0.0, 0.0, 0.0}), presence({0.6, 0.5, 0.0, 0.0}));
  EXPECT_GT(presence({0.6, 0.5, 0.0, 0.0}), presence({0.6, 0.5, 0.5, 0.5}));
}

TEST(PlaceLogOdds, OfAPlaceThatTheMapCannotJudgeAreNeverSure) {
  // A view along a corridor whose end is not mapped.
  VerifiedPlace place = places_of_fits({0.6}).front();
  const PlaceScale scale{place_rank(place_features(place)), 8.0};
  EXPECT_NEAR(place_log_odds(place, scale), 8.0, 1e-12);
  place.unjudged_share = kMaxUnjudged + 0.01;
  EXPECT_NEAR(place_log_odds(place, scale), kUnsure, 1e-12);
  const std::vector<double> odds{place_log_odds(place, scale)};
  EXPECT_LT(place_probabilities(odds).front(), LocalisationParams{}.min_probability);
}

}  // namespace setsquare::place_probability_test
