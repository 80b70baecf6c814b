// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/agreed_place.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

namespace setsquare::agreed_place_test {

const Pose2 kHere{1.0, 0.0, 0.0};
const Pose2 kNearHere{1.1, 0.0, 0.02};
const Pose2 kElsewhere{4.0, 0.0, 0.0};
const ExpectedStep kStepHere{{0.0, 0.0, 0.0}, {1.5, 1.0}};

const Pose2 kJustBeyond{1.7, 0.0, 0.0};  ///< The reach of kStepHere.

PlaceVote vote(const Pose2& T_odom_sensor, MatchStatus status, double probability = 0.999) {
  return {T_odom_sensor, status, probability};
}

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
  const PlaceVote ambiguous = vote(kJustBeyond, MatchStatus::kAmbiguous);
  const PlaceVote alone = vote(kJustBeyond, MatchStatus::kMatched);
  ExpectedStep by_odometry = kStepHere;
  by_odometry.by = ExpectedStep::By::kOdometry;
  for (const ExpectedStep& step : {kStepHere, by_odometry}) {
    EXPECT_FALSE(agreed({ambiguous, ambiguous, ambiguous, ambiguous}, step));
    EXPECT_TRUE(agreed({alone, ambiguous}, step));
    EXPECT_TRUE(agreed({vote(kHere, MatchStatus::kMatched)}, step)) << "within reach";
  }
  EXPECT_TRUE(agreed({ambiguous, ambiguous, ambiguous, ambiguous})) << "without the rule";
  EXPECT_FALSE(agreed({alone}, by_odometry)) << "too few votes for a jump";
  EXPECT_TRUE(agreed({alone})) << "without the rule";
}

// A robot that turns by 45 deg from key frame to key frame does not turn by 134 between two, and
// yet four keyframes of one room may all say so, each surely.
TEST(AgreedPlace, ByTheLastMotionAJumpNeedsMatchesAsSureAsItIsFar) {
  const auto is_agreed = [](const Pose2& place, double probability, const PlaceVoteParams& params) {
    const std::vector<PlaceVote> votes(4, vote(place, MatchStatus::kMatched, probability));
    return agreed_place(votes, kStepHere, params).has_value();
  };
  EXPECT_TRUE(is_agreed(kJustBeyond, 0.999, {}));
  EXPECT_FALSE(is_agreed({0.5, 0.0, 2.4}, 0.999, {}));
  EXPECT_FALSE(is_agreed(kElsewhere, 1.0, {}));
  PlaceVoteParams without;
  without.odds.decades_per_reach = 0.0;
  EXPECT_TRUE(is_agreed(kElsewhere, 1.0, without)) << "without the rule";
}

TEST(ProbablePlace, IsWhereADegenerateMatchHasTheScanWithinReach) {
  PlaceVote open = vote(kHere, MatchStatus::kDegenerate, 0.6);
  open.open_direction_rad = 0.3;
  EXPECT_FALSE(agreed({open}, kStepHere)) << "without the rule";
  const auto place = probable_place(std::vector{open}, kStepHere, {});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->T_odom_sensor, kHere);
  EXPECT_TRUE(place->is_open);
  EXPECT_EQ(place->open_direction_rad, 0.3);
  open.T_odom_sensor = kElsewhere;
  EXPECT_FALSE(probable_place(std::vector{open}, kStepHere, {})) << "beyond reach";
  EXPECT_FALSE(probable_place({}, kStepHere, {}));
}

TEST(ProbablePlace, IsNotOpenWhereAMatchDeterminesIt) {
  const auto place = probable_place(std::vector{vote(kHere, MatchStatus::kDegenerate, 0.9),
                                                vote(kNearHere, MatchStatus::kAmbiguous, 0.8)},
                                    kStepHere,
                                    {});
  ASSERT_TRUE(place);
  EXPECT_FALSE(place->is_open);
}

TEST(ProbablePlace, IsNoneWhereTwoAreLikelyOrNothingOverlaps) {
  const PlaceVote here = vote(kHere, MatchStatus::kDegenerate, 0.9);
  const PlaceVote back = vote({-1.0, 0.0, 0.0}, MatchStatus::kDegenerate, 0.9);
  EXPECT_TRUE(probable_place(std::vector{here}, kStepHere, {}));
  EXPECT_FALSE(probable_place(std::vector{here, back}, kStepHere, {}));
  EXPECT_FALSE(
      probable_place(std::vector{vote(kHere, MatchStatus::kNoOverlap, 0.9)}, kStepHere, {}));
}

// Laws: the farther a robot would have gone, the more its motion speaks against it; a longer reach
// speaks less for what lies within it; a surer match has better odds, and none is certain.
TEST(StepOdds, GrowWithTheWayBeyondTheReach) {
  double last = odds_against(kStepHere, kStepHere.T_odom_sensor, {});
  EXPECT_GT(last, 0.0);
  EXPECT_EQ(odds_against(kStepHere, {1.4, 0.0, 0.9}, {}), last) << "all within reach";
  for (double way_m = 1.6; way_m < 20.0; way_m *= 1.3) {
    const double against = odds_against(kStepHere, {0.0, way_m, 0.0}, {});
    EXPECT_GT(against, last) << way_m;
    last = against;
  }
  const ExpectedStep longer{{0.0, 0.0, 0.0}, {3.0, 1.0}};
  EXPECT_GT(odds_against(longer, kHere, {}), odds_against(kStepHere, kHere, {}));
  const ExpectedStep anywhere{{0.0, 0.0, 0.0}, {50.0, 2.0 * kPi}};
  EXPECT_EQ(odds_against(anywhere, kHere, {}), 1.0) << "nothing is known of the step";
}

TEST(StepOdds, GrowWithTheProbabilityOfAMatchAndAreFinite) {
  double last = log_odds_of_place(0.0, 1.0, {});
  EXPECT_TRUE(std::isfinite(last));
  for (const double probability : {0.1, 0.5, 0.9, 0.999, 0.9999}) {
    const double odds = log_odds_of_place(probability, 1.0, {});
    EXPECT_GT(odds, last);
    EXPECT_NEAR(odds, std::log(probability / (1.0 - probability)), 1e-9);
    last = odds;
  }
  EXPECT_TRUE(std::isfinite(log_odds_of_place(1.0, 1.0, {})));
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
