// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The laws of the probability; that it is calibrated is benchmarks/match_probability's to show.
#include "setsquare/matching/probability.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "setsquare/matching/scan_matcher.hpp"
#include "tests/support/seed.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare::probability_test {

/// Of a good match.
ProbabilityEvidence good_evidence() {
  return {.kinds = {.wall_m = 50.0,
                    .tight_m = 28.0,
                    .loose_m = 30.0,
                    .clutter_m = 1.0,
                    .contradicted_m = 0.3,
                    .hidden_m = 5.0,
                    .unexplained_m = 2.0,
                    .outside_m = 10.0},
          .constraint = {.all_m = 20.0, .open_direction_m = 6.0, .turning_m3 = 60.0},
          .score = 0.5,
          .margin = 0.4,
          .one_way_share = 0.01,
          .distinct_wall_m = 8.0};
}

TEST(Probability, IsAProbabilityWhateverTheEvidence) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 2000; ++trial) {
    const auto any_m = [&] { return std::exp(testing::uniform(generator, -8.0, 6.0)); };
    ProbabilityEvidence evidence = good_evidence();
    evidence.kinds = {.wall_m = any_m(),
                      .tight_m = any_m(),
                      .loose_m = any_m(),
                      .clutter_m = any_m(),
                      .contradicted_m = any_m(),
                      .hidden_m = any_m(),
                      .unexplained_m = any_m(),
                      .outside_m = any_m()};
    evidence.margin = testing::uniform(generator, -1.0, 1.5);
    evidence.distinct_wall_m = any_m();
    const double probability = match_probability(evidence);
    EXPECT_GE(probability, 0.0);
    EXPECT_LE(probability, 1.0);
  }
  EXPECT_LT(match_probability({}), 0.01) << "nothing seen in common";
}

TEST(Probability, WhatSpeaksAgainstTheAnswerLowersIt) {
  const double good = match_probability(good_evidence());
  EXPECT_GT(good, 0.999);
  const auto changed = [](auto&& change) {
    ProbabilityEvidence evidence = good_evidence();
    change(evidence);
    return match_probability(evidence);
  };
  EXPECT_LT(changed([](auto& e) { e.kinds.contradicted_m = 6.0; }), good);
  EXPECT_LT(changed([](auto& e) { e.kinds.tight_m = 15.0; }), good);
  EXPECT_LT(changed([](auto& e) { e.margin = 0.02; }), good);
  EXPECT_LT(changed([](auto& e) { e.one_way_share = 0.4; }), good);
  EXPECT_LT(changed([](auto& e) { e.distinct_wall_m = 1.0; }), good);
  EXPECT_LT(changed([](auto& e) { e.constraint.open_direction_m = 0.05; }), good);
}

TEST(Probability, TheMapOfTheLogOddsIsMonotone) {
  for (double log_odds = -30.0; log_odds < 30.0; log_odds += 0.1) {
    EXPECT_LT(calibrated_log_odds(log_odds), calibrated_log_odds(log_odds + 0.1));
  }
}

/// Of answers in buildings that had no part in the fit (`match_probability check`, seeds 1 to 16
/// and 5001 to 5020), each field of view weighing alike: the weighted sum, and how many were right.
TEST(Probability, AnswersAreRightAsOftenAsTheMapOfTheirLogOddsSays) {
  struct Measured {
    double log_odds = 0.0;
    double share_right = 0.0;
  };
  for (const auto& [log_odds, share_right] : {Measured{-3.5, 0.055},
                                              Measured{-2.5, 0.109},
                                              Measured{-1.5, 0.205},
                                              Measured{-0.5, 0.416},
                                              Measured{0.5, 0.646},
                                              Measured{1.5, 0.859},
                                              Measured{2.5, 0.958},
                                              Measured{3.5, 0.988}}) {
    const double claimed = 1.0 / (1.0 + std::exp(-calibrated_log_odds(log_odds)));
    EXPECT_NEAR(claimed, share_right, 0.035) << log_odds;
  }
}

TEST(Probability, EachAliasIsAsProbableAsTheAnswer) {
  const double alone = match_probability(good_evidence());
  for (const std::size_t num_aliases : {1U, 2U, 5U}) {
    EXPECT_DOUBLE_EQ(match_probability(good_evidence(), num_aliases),
                     alone / static_cast<double>(1 + num_aliases));
  }
}

TEST(Probability, IsHighForTwoScansOfARoomAndLowForTwoRooms) {
  const testing::Fan fan{720, -kPi, rad_from_deg(0.5)};
  const auto room = testing::l_shaped_room();
  const Scan reference = testing::scan_of_walls(room, {2.0, 2.5, 0.3}, fan, 0.01, 1);
  const Scan current = testing::scan_of_walls(room, {3.0, 2.2, 1.1}, fan, 0.01, 2);
  EXPECT_GT(match(reference, current).probability, 0.999);
  const std::vector<testing::Wall> other{
      {0.0, 0.0, 3.1, 0.4}, {3.1, 0.4, 4.0, 3.0}, {4.0, 3.0, 1.0, 4.2}, {1.0, 4.2, 0.0, 0.0}};
  const Scan elsewhere = testing::scan_of_walls(other, {2.0, 1.5, 0.3}, fan, 0.01, 3);
  EXPECT_LT(match(reference, elsewhere).probability, 0.5);
  Scan blind = reference;
  blind.ranges_m.assign(blind.num_beams(), 81.83);
  EXPECT_TRUE(std::isnan(match(reference, blind).probability)) << "there is no answer";
}

}  // namespace setsquare::probability_test
