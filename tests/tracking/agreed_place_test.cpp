// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/agreed_place.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace setsquare::agreed_place_test {

const Pose2 kHere{1.0, 0.0, 0.0};
const Pose2 kNearHere{1.1, 0.0, 0.02};
const Pose2 kElsewhere{4.0, 0.0, 0.0};
const ExpectedStep kStepHere{{0.0, 0.0, 0.0}, {1.5, 1.0}};

PlaceVote vote(const Pose2& T_odom_sensor, MatchStatus status) { return {T_odom_sensor, status}; }

std::optional<AgreedPlace> agreed(const std::vector<PlaceVote>& votes,
                                  const std::optional<ExpectedStep>& step = std::nullopt) {
  return agreed_place(votes, step, {});
}

TEST(AgreedPlace, OneMatchThatStandsAloneIsEnough) {
  const auto place = agreed({vote(kHere, MatchStatus::kMatched)});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->T_odom_sensor, kHere);
  EXPECT_EQ(place->votes, 1.0);
}

TEST(AgreedPlace, TwoAmbiguousMatchesAreEnoughAndOneIsNot) {
  const PlaceVote ambiguous = vote(kHere, MatchStatus::kAmbiguous);
  EXPECT_FALSE(agreed({ambiguous}));
  EXPECT_TRUE(agreed({ambiguous, vote(kNearHere, MatchStatus::kAmbiguous)}));
}

TEST(AgreedPlace, AShortStepSpeaksForAnAmbiguousMatch) {
  EXPECT_TRUE(agreed({vote(kHere, MatchStatus::kAmbiguous)}, kStepHere));
  EXPECT_FALSE(agreed({vote(kElsewhere, MatchStatus::kAmbiguous)}, kStepHere));
}

TEST(AgreedPlace, TheLatestKeyframeOfThoseThatAgreeGivesThePose) {
  const auto place =
      agreed({vote(kHere, MatchStatus::kMatched), vote(kNearHere, MatchStatus::kMatched)});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->T_odom_sensor, kHere);
  EXPECT_EQ(place->votes, 2.0);
}

TEST(AgreedPlace, KeyframesThatContradictEachOtherDoNotAgree) {
  const std::vector<PlaceVote> votes{vote(kHere, MatchStatus::kMatched),
                                     vote(kElsewhere, MatchStatus::kMatched)};
  EXPECT_FALSE(agreed(votes));
  const auto by_step = agreed(votes, kStepHere);
  ASSERT_TRUE(by_step);
  EXPECT_EQ(by_step->T_odom_sensor, kHere);
}

TEST(AgreedPlace, TheMajorityWins) {
  const auto place = agreed({vote(kElsewhere, MatchStatus::kMatched),
                             vote(kHere, MatchStatus::kMatched),
                             vote(kNearHere, MatchStatus::kMatched)});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->T_odom_sensor, kHere);
}

TEST(AgreedPlace, MatchesThatDetermineNoPlaceHaveNoVote) {
  EXPECT_FALSE(agreed({vote(kHere, MatchStatus::kDegenerate),
                       vote(kHere, MatchStatus::kNoOverlap),
                       vote(kHere, MatchStatus::kDegenerate)},
                      kStepHere));
  EXPECT_FALSE(agreed({}));
}

// One room takes a scan for its wrong half in each of its keyframes; a corridor without end, too.
TEST(AgreedPlace, BeyondTheReachOfAStepAJumpNeedsAMatchThatStandsAlone) {
  const PlaceVote ambiguous = vote(kElsewhere, MatchStatus::kAmbiguous);
  const PlaceVote alone = vote(kElsewhere, MatchStatus::kMatched);
  EXPECT_FALSE(agreed({ambiguous, ambiguous, ambiguous, ambiguous}, kStepHere));
  EXPECT_TRUE(agreed({ambiguous, ambiguous, ambiguous, ambiguous})) << "without the rule";
  EXPECT_FALSE(agreed({alone}, kStepHere)) << "too few votes for a jump";
  EXPECT_TRUE(agreed({alone})) << "without the rule";
  EXPECT_TRUE(agreed({alone, ambiguous}, kStepHere));
  EXPECT_TRUE(agreed({vote(kHere, MatchStatus::kMatched)}, kStepHere)) << "within reach";
}

TEST(AgreedPlace, OdometrySpeaksAgainstAPlaceBeyondItsReachAsGoodAsItHasProved) {
  using By = ExpectedStep::By;
  const AgreedPlace one{kElsewhere, 1.0};
  const AgreedPlace two{kElsewhere, 2.0};
  const auto refuted = [](const AgreedPlace& place, By by, bool fits_as_driven) {
    ExpectedStep step = kStepHere;
    step.by = by;
    return is_refuted(place, step, fits_as_driven, {});
  };
  EXPECT_FALSE(refuted(one, By::kLastMotion, true));
  EXPECT_TRUE(refuted(one, By::kOdometry, true));
  EXPECT_FALSE(refuted(one, By::kOdometry, false));
  EXPECT_FALSE(refuted(two, By::kOdometry, true));
  EXPECT_TRUE(refuted(one, By::kProvedOdometry, false));
  EXPECT_TRUE(refuted(two, By::kProvedOdometry, true));
  EXPECT_FALSE(refuted(two, By::kProvedOdometry, false));
  EXPECT_FALSE(refuted({kHere, 1.0}, By::kProvedOdometry, true)) << "within reach";
}

TEST(AgreedPlace, ADepartureIsFromOdometryAndBeyondItsReach) {
  ExpectedStep step = kStepHere;
  EXPECT_FALSE(departure_from(step, kElsewhere));
  for (const auto by : {ExpectedStep::By::kOdometry, ExpectedStep::By::kProvedOdometry}) {
    step.by = by;
    EXPECT_FALSE(departure_from(step, kHere));
    const auto departure = departure_from(step, {4.0, 3.0, -0.5});
    ASSERT_TRUE(departure);
    EXPECT_DOUBLE_EQ(departure->distance_m, 5.0);
    EXPECT_DOUBLE_EQ(departure->turn_rad, 0.5);
    EXPECT_TRUE(departure_from(step, {0.0, 0.0, 1.2}));
  }
}

}  // namespace setsquare::agreed_place_test
