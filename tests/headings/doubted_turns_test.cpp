// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/headings/fusion.hpp"
#include "tests/headings/simulated_headings.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::doubted_turns_test {

using testing::make_generator;
using testing::simulate_headings;
using testing::SimulatedHeadings;

/// A building whose walls turn by so much at keyframe 200.
SimulatedHeadings walls_that_turn(double turn_rad) {
  auto generator = make_generator();
  return simulate_headings({.num_keyframes = 400,
                            .measurement_noise_rad = rad_from_deg(0.2),
                            .wing_offset_rad = {0.0, turn_rad},
                            .keyframes_per_wing = 200},
                           generator);
}

TEST(DoubtedTurns, AreNoneWhereTheWallsStandStill) {
  EXPECT_TRUE(fuse_headings(walls_that_turn(0.0).evidence).doubted.empty());
}

TEST(DoubtedTurns, IsWhereTheWallsTurn) {
  for (const double turn_deg : {-31.0, -6.0, 4.0, 12.0}) {
    const FusedHeadings fused = fuse_headings(walls_that_turn(rad_from_deg(turn_deg)).evidence);
    ASSERT_FALSE(fused.doubted.empty()) << turn_deg;
    EXPECT_LT(fused.doubted.front().from, 200U);
    EXPECT_GE(fused.doubted.front().to, 200U);
    EXPECT_LE(fused.doubted.front().to - fused.doubted.front().from, 3U);
  }
}

TEST(DoubtedTurns, AreSettledByMatches) {
  SimulatedHeadings simulated = walls_that_turn(rad_from_deg(7.0));
  EXPECT_EQ(fuse_headings(simulated.evidence).frames.size(), 1U) << "a slip, for all that is known";
  for (HeadingEvidence& keyframe : simulated.evidence) keyframe.is_step_confirmed = true;
  const FusedHeadings fused = fuse_headings(simulated.evidence);
  EXPECT_TRUE(fused.doubted.empty());
  ASSERT_EQ(fused.frames.size(), 2U);
  EXPECT_NEAR(std::abs(fused.frames[1].offset_rad), rad_from_deg(7.0), rad_from_deg(0.3));
}

TEST(DoubtedTurns, AreSettledWhereWallsAreKnownToBeTurned) {
  const SimulatedHeadings simulated = walls_that_turn(rad_from_deg(7.0));
  const std::vector<TurnedWalls> turned{
      {.first = 200, .end = 400, .turn_rad = rad_from_deg(-6.5), .sigma_rad = rad_from_deg(0.5)}};
  EXPECT_FALSE(fuse_headings(simulated.evidence).doubted.empty());
  const FusedHeadings fused = fuse_headings(simulated.evidence, {}, turned);
  EXPECT_TRUE(fused.doubted.empty());
  ASSERT_EQ(fused.frames.size(), 2U);
  EXPECT_NEAR(fused.frames[1].offset_rad, rad_from_deg(7.0), rad_from_deg(0.3));
  EXPECT_NEAR(fused.frames[1].support, 200.0, 20.0);
}

TEST(DoubtedTurns, AStepAndADriftAtOnePlaceAreOneTurn) {
  const auto turns = distinct_turns({{.from = 40, .to = 41, .turned_rad = rad_from_deg(6.0)},
                                     {.from = 90, .to = 91, .turned_rad = rad_from_deg(5.0)},
                                     {.from = 38, .to = 43, .turned_rad = rad_from_deg(-9.0)},
                                     {.from = 43, .to = 44, .turned_rad = rad_from_deg(4.0)}});
  ASSERT_EQ(turns.size(), 3U);
  EXPECT_EQ(turns[0].from, 38U);
  EXPECT_EQ(turns[0].to, 43U);
  EXPECT_DOUBLE_EQ(turns[0].turned_rad, rad_from_deg(-9.0));
  EXPECT_EQ(turns[1].from, 43U) << "beside it, another one";
  EXPECT_EQ(turns[2].from, 90U);
}

// A sure step of six degrees is seen by its two keyframes and by the drift alike.
TEST(DoubtedTurns, AreListedTwiceWithoutThat) {
  const FusedHeadings fused = fuse_headings(walls_that_turn(rad_from_deg(-6.0)).evidence);
  EXPECT_GT(fused.doubted.size(), 1U);
  EXPECT_EQ(distinct_turns(fused.doubted).size(), 1U);
}

TEST(DoubtedTurns, RefuseWrongParameters) {
  EXPECT_THROW(DoubtedTurnParams{.num_steps = 0}.validate(), ParameterError);
  EXPECT_THROW(DoubtedTurnParams{.min_rad = 0.0}.validate(), ParameterError);
  EXPECT_THROW(DoubtedTurnParams{.min_belief = -1.0}.validate(), ParameterError);
  EXPECT_NO_THROW(DoubtedTurnParams{}.validate());
}

}  // namespace setsquare::doubted_turns_test
