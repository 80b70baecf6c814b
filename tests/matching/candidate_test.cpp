// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The score's laws, whatever its parameters' values.
#include <gtest/gtest.h>

#include <cmath>

#include "setsquare/matching/candidates.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::candidate_test {

using testing::uniform;

Evidence random_evidence(std::mt19937_64& generator) {
  Evidence evidence{.agreeing_m = uniform(generator, 0.0, 20.0),
                    .contradicted_m = uniform(generator, 0.0, 5.0),
                    .hidden_m = uniform(generator, 0.0, 10.0),
                    .outside_m = uniform(generator, 0.0, 10.0)};
  // Some wall lies near a surface that faces another way, or agrees in part.
  evidence.wall_m = evidence.agreeing_m + evidence.contradicted_m + evidence.hidden_m +
                    evidence.outside_m + uniform(generator, 0.0, 3.0);
  return evidence;
}

TEST(Score, IsAtMostOneAndOneWhereAllAgrees) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 1000; ++trial) {
    EXPECT_LE(score(random_evidence(generator), {}), 1.0);
  }
  EXPECT_DOUBLE_EQ(score({.wall_m = 7.0, .agreeing_m = 7.0}, {}), 1.0);
}

TEST(Score, OfNothingIsZero) {
  EXPECT_EQ(score({}, {}), 0.0);
  EXPECT_EQ(score({.wall_m = std::nan("")}, {}), 0.0);
}

TEST(Score, FallsWhereAgreeingWallIsContradictedHiddenOrElsewhere) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 1000; ++trial) {
    const Evidence before = random_evidence(generator);
    const double moved_m = uniform(generator, 0.001, 1.0) * before.agreeing_m;
    for (double Evidence::*elsewhere :
         {&Evidence::contradicted_m, &Evidence::hidden_m, &Evidence::outside_m}) {
      Evidence after = before;
      after.agreeing_m -= moved_m;
      after.*elsewhere += moved_m;
      EXPECT_LT(score(after, {}), score(before, {}));
    }
  }
}

TEST(Score, FallsWithEveryContradictionAndMostWithTheFirst) {
  const auto at = [](double share) {
    return score({.wall_m = 10.0, .agreeing_m = 5.0, .contradicted_m = 10.0 * share}, {});
  };
  double last_step = 1.0;
  for (double share = 0.0; share < 0.45; share += 0.01) {
    const double step = at(share) - at(share + 0.01);
    EXPECT_GT(step, 0.0);
    EXPECT_LT(step, last_step) << share;
    last_step = step;
  }
}

TEST(Score, DoesNotDependOnTheUnitOfLength) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 200; ++trial) {
    const Evidence evidence = random_evidence(generator);
    const double k = std::exp(uniform(generator, -5.0, 5.0));
    const Evidence scaled{.wall_m = k * evidence.wall_m,
                          .agreeing_m = k * evidence.agreeing_m,
                          .contradicted_m = k * evidence.contradicted_m,
                          .hidden_m = k * evidence.hidden_m,
                          .outside_m = k * evidence.outside_m};
    EXPECT_NEAR(score(scaled, {}), score(evidence, {}), 1e-12);
  }
}

TEST(Score, WhatTheOtherCannotJudgeCountsForLess) {
  const ScoreParams params;
  const double judged = score({.wall_m = 10.0, .agreeing_m = 6.0}, params);
  const double outside = score({.wall_m = 10.0, .agreeing_m = 6.0, .outside_m = 4.0}, params);
  EXPECT_DOUBLE_EQ(judged, 0.6);
  EXPECT_DOUBLE_EQ(outside, 6.0 / (10.0 - 4.0 * params.outside_discount));
}

TEST(AreSame, BothTranslationAndRotationDecide) {
  const AnswerParams params;
  const Pose2 a{1.0, 2.0, 3.1};
  EXPECT_TRUE(are_same(a, {1.2, 2.2, wrap_to_pi(3.19)}, params));
  EXPECT_FALSE(are_same(a, {1.2, 2.25, 3.1}, params));
  EXPECT_FALSE(are_same(a, {1.0, 2.0, wrap_to_pi(3.21)}, params));
}

}  // namespace setsquare::candidate_test
