// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/view_probability.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "setsquare/localisation/place_probability.hpp"

namespace setsquare::view_probability_test {

/// Places apart from each other, by their fits.
std::vector<VerifiedPlace> places_of_fits(const std::vector<double>& fits) {
  std::vector<VerifiedPlace> places;
  for (const double fit : fits) {
    VerifiedPlace place;
    place.T_grid_sensor = {5.0 * static_cast<double>(places.size()), 0.0, 0.0};
    place.fit = fit;
    place.unjudged_share = 0.0;
    places.push_back(place);
  }
  return places;
}

constexpr SeenByViews kAgrees{
    .num_views = 5, .wall_m = 10.0, .tight_m = 9.0, .loose_m = 10.0, .distance_m = 0.005};
constexpr SeenByViews kContradicted{.num_views = 5,
                                    .wall_m = 10.0,
                                    .tight_m = 5.0,
                                    .loose_m = 7.0,
                                    .through_m = 3.0,
                                    .distance_m = 0.06,
                                    .missed_m = 2.0};
constexpr SeenByViews kUnseen{.num_views = 0, .wall_m = 10.0, .outside_m = 10.0};

TEST(RanksByViews, PlacesThatAreAlikeInTheGridDifferByWhatTheScansSaw) {
  const std::vector<VerifiedPlace> places = places_of_fits({0.6, 0.6});
  const std::vector<SeenByViews> seen{kContradicted, kAgrees};
  const std::vector<double> ranks = ranks_by_views(places, seen);
  EXPECT_GT(ranks[1], ranks[0] + 3.0);
}

TEST(RanksByViews, APlaceThatNoScanSawIsComparedByTheGridAlone) {
  const std::vector<VerifiedPlace> places = places_of_fits({0.6, 0.7, 0.5});
  const std::vector<SeenByViews> seen{kAgrees, kUnseen, kContradicted};
  const std::vector<double> ranks = ranks_by_views(places, seen);
  const auto by_grid = [&](std::size_t i) { return place_rank(place_features(places[i])); };
  EXPECT_NEAR(ranks[1] - ranks[0], by_grid(1) - by_grid(0), 1e-9);
  // Where none saw anything all are.
  const std::vector<SeenByViews> nothing{kUnseen, kUnseen, kUnseen};
  const std::vector<double> alone = ranks_by_views(places, nothing);
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_NEAR(alone[i], by_grid(i), 1e-9);
}

TEST(ViewSharpness, SmallDistancesTellWhereScansAreSharp) {
  SeenByViews noisy = kAgrees;
  noisy.distance_m = 0.05;
  const std::vector<SeenByViews> sharp{kAgrees, kContradicted};
  const std::vector<SeenByViews> blurred{noisy, kContradicted};
  EXPECT_GT(view_sharpness(sharp).weight, 0.8);
  EXPECT_LT(view_sharpness(blurred).weight, 0.2);
  // A place on which little lies sharply says nothing.
  SeenByViews little = kAgrees;
  little.loose_m = 1.0;
  const std::vector<SeenByViews> mixed{noisy, little};
  EXPECT_LT(view_sharpness(mixed).weight, 0.2);
}

TEST(LogOddsByViews, AreNeverSureWhereNeitherTheGridNorScansCanJudge) {
  std::vector<VerifiedPlace> places = places_of_fits({0.9, 0.0, 0.0, 0.0});
  places[0].score = 0.9;
  const auto best = [&](const SeenByViews& of_best) {
    const std::vector<SeenByViews> seen{of_best, kUnseen, kUnseen, kUnseen};
    return log_odds_by_views(places, seen).front();
  };
  EXPECT_GT(best(kUnseen), kUnsure);
  places[0].unjudged_share = kMaxUnjudged + 0.01;
  EXPECT_LE(best(kUnseen), kUnsure);
  EXPECT_GT(best(kAgrees), kUnsure);
  EXPECT_TRUE(log_odds_by_views({}, {}).empty());
}

}  // namespace setsquare::view_probability_test
