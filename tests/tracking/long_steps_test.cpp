// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/long_steps.hpp"

#include <gtest/gtest.h>

namespace setsquare::long_steps_test {

constexpr Pose2 kShort{0.1, 0.0, 0.02};
constexpr Pose2 kLong{1.0, 0.0, 0.0};
constexpr Pose2 kTurn{0.0, 0.0, rad_from_deg(-70.0)};

TEST(LongSteps, AreExpectedUntilTheStepsAreKnown) {
  LongSteps steps({});
  for (std::size_t i = 0; i < LongStepParams{}.num_steps; ++i) {
    EXPECT_TRUE(steps.are_expected());
    EXPECT_FALSE(steps.are_usual());
    steps.add(kShort);
  }
  EXPECT_FALSE(steps.are_expected());
}

TEST(LongSteps, AreUsualWhereSeveralOfTheLatestWere) {
  LongSteps steps({});
  for (int i = 0; i < 20; ++i) steps.add(kShort);
  steps.add(kLong);
  steps.add(kTurn);
  steps.add(kLong);
  EXPECT_FALSE(steps.are_expected());
  steps.add(kLong);
  EXPECT_TRUE(steps.are_usual());
  for (int i = 0; i < 10; ++i) steps.add(kShort);
  EXPECT_FALSE(steps.are_expected());
}

TEST(LongSteps, ReachAsFarAsTheLatestAndSomewhatFarther) {
  const LongStepParams params;
  LongSteps steps(params);
  EXPECT_EQ(steps.reach().distance_m, params.least_reach_m);
  EXPECT_EQ(steps.reach().turn_rad, params.least_reach_rad);
  steps.add({3.0, 4.0, 0.0});
  steps.add(kTurn);
  EXPECT_DOUBLE_EQ(steps.reach().distance_m, 5.0 * params.reach_per_step);
  EXPECT_DOUBLE_EQ(steps.reach().turn_rad, rad_from_deg(70.0) * params.reach_per_step);
}

}  // namespace setsquare::long_steps_test
