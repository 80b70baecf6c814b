// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Headings of a straight drive, turns that the walls left undecided, and matches across them.
#include "setsquare/mapping/told_turns.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "setsquare/core/angle.hpp"

namespace setsquare::told_turns_test {

constexpr double kSlip_rad = rad_from_deg(9.0);

/// Twenty keyframes. The walls turned by 9 degrees at keyframe 6 and at 12; by -4 at 16. The fusion
/// followed tracking everywhere.
FusedHeadings headings() {
  FusedHeadings fused;
  fused.heading_rad.assign(20, 0.0);
  fused.drift_rad.assign(20, 0.0);
  fused.doubted = {{.from = 5, .to = 6, .turned_rad = kSlip_rad},
                   {.from = 11, .to = 12, .turned_rad = kSlip_rad},
                   {.from = 15, .to = 16, .turned_rad = rad_from_deg(-4.0)}};
  return fused;
}

MapHypothesis turned(std::size_t from, std::size_t to, double by_deg) {
  MapHypothesis told;
  told.keyframe_from = from;
  told.keyframe_to = to;
  told.T_from_to = {1.0, 0.0, rad_from_deg(by_deg)};
  return told;
}

TEST(ToldTurns, ATurnIsDecidedByTheMatchesAcrossIt) {
  const std::vector<MapHypothesis> told{turned(2, 8, 9.5), turned(3, 9, 8.5), turned(1, 9, 9.0)};
  const auto turns = told_turns(headings(), told, {});
  ASSERT_EQ(turns.size(), 1U);
  EXPECT_EQ(turns[0].turn.to, 6U);
  EXPECT_NEAR(turns[0].beyond_rad, kSlip_rad, 1e-12) << "the median";
}

TEST(ToldTurns, MatchesFromTheLaterScanSayTheSame) {
  const auto turns = told_turns(headings(), std::vector{turned(9, 2, -9.0)}, {});
  ASSERT_EQ(turns.size(), 1U);
  EXPECT_NEAR(turns[0].beyond_rad, kSlip_rad, 1e-12);
}

TEST(ToldTurns, WhatTheFusionTookForASlipMayHaveBeenNone) {
  FusedHeadings fused = headings();
  for (std::size_t k = 6; k < 20; ++k) fused.drift_rad[k] = fused.heading_rad[k] = kSlip_rad;
  const auto turns = told_turns(fused, std::vector{turned(2, 8, 0.0)}, {});
  ASSERT_EQ(turns.size(), 1U);
  EXPECT_NEAR(turns[0].beyond_rad, 0.0, 1e-12);
}

TEST(ToldTurns, MatchesThatTurnByAnotherAngleDecideNothing) {
  EXPECT_TRUE(told_turns(headings(), std::vector{turned(2, 8, 30.0)}, {}).empty());
  EXPECT_TRUE(told_turns(headings(), std::vector{turned(7, 10, 9.0)}, {}).empty()) << "not across";
  EXPECT_TRUE(told_turns(headings(), std::vector<MapHypothesis>{}, {}).empty());
}

TEST(ToldTurns, TheTurnThatExplainsMostComesFirst) {
  const std::vector<MapHypothesis> told{turned(2, 14, 9.0), turned(8, 14, 9.0), turned(9, 13, 9.0)};
  const auto turns = told_turns(headings(), told, {});
  ASSERT_EQ(turns.size(), 2U);
  EXPECT_EQ(turns[0].turn.to, 12U);
  EXPECT_EQ(turns[1].turn.to, 6U);
}

}  // namespace setsquare::told_turns_test
