// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Each rule of the verdict alone turns an answer that stands into one that does not.
#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <string>

#include "setsquare/matching/verdict.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::match_verdict_test {

/// The evidence of a good match, with margin to every rule.
struct Case {
  std::vector<Candidate> candidates{
      {.T_reference_current = {0.5, 0.1, 0.2},
       .evidence = {.wall_m = 20.0, .agreeing_m = 12.0, .contradicted_m = 0.2, .hidden_m = 4.0},
       .score = 0.5},
      {.T_reference_current = {0.5, 2.1, 0.2},
       .evidence = {.wall_m = 20.0, .agreeing_m = 6.0, .contradicted_m = 3.0, .hidden_m = 4.0},
       .score = 0.1}};
  double runner_up_score = 0.1;
  WallConstraint constraint{.all_m = 10.0, .open_direction_m = 3.0, .turning_m3 = 20.0};
  TwoWayEvidence two_way{{.wall_m = 10.0, .agreeing_m = 6.0, .contradicted_m = 0.1},
                         {.wall_m = 10.0, .agreeing_m = 6.0, .contradicted_m = 0.1}};
  double distinct_wall_m = 8.0;
  double probability = 0.99;  ///< Enough with the rules of the score, not without.
  std::size_t num_aliases = 0;
  std::optional<double> place_log_odds;
  AnswerParams params;

  [[nodiscard]] MatchStatus verdict() const {
    return setsquare::verdict({.candidates = candidates,
                               .runner_up_score = runner_up_score,
                               .constraint = constraint,
                               .two_way = two_way,
                               .distinct_wall_m = distinct_wall_m,
                               .probability = probability,
                               .num_aliases = num_aliases,
                               .place_log_odds = place_log_odds},
                              params);
  }
};

TEST(Verdict, AGoodMatchStands) { EXPECT_EQ(Case{}.verdict(), MatchStatus::kMatched); }

/// What is just within a rule and just beyond it, all else being good.
struct Rule {
  const char* name;
  std::function<void(Case&)> obey;
  std::function<void(Case&)> break_it;
  MatchStatus broken;
};

void PrintTo(const Rule& rule, std::ostream* out) { *out << rule.name; }

class VerdictRule : public ::testing::TestWithParam<Rule> {};

TEST_P(VerdictRule, AloneDecides) {
  Case within;
  GetParam().obey(within);
  EXPECT_EQ(within.verdict(), MatchStatus::kMatched);
  Case beyond;
  GetParam().break_it(beyond);
  EXPECT_EQ(beyond.verdict(), GetParam().broken);
}

void set_score(Case& c, double score, double runner_up_score) {
  c.candidates[0].score = score;
  c.candidates[1].score = runner_up_score;
  c.runner_up_score = runner_up_score;
}

/// A different pose, with this much agreeing and this much contradicted wall.
void set_rival(Case& c, double agreeing_m, double contradicted_m) {
  c.candidates[1].evidence.agreeing_m = agreeing_m;
  c.candidates[1].evidence.contradicted_m = contradicted_m;
}

constexpr auto kAmbiguous = MatchStatus::kAmbiguous;
constexpr auto kDegenerate = MatchStatus::kDegenerate;

INSTANTIATE_TEST_SUITE_P(
    Rules,
    VerdictRule,
    ::testing::Values(
        Rule{"min_agreement",
             [](Case& c) { c.candidates[0].evidence.wall_m = 119.0; },
             [](Case& c) { c.candidates[0].evidence.wall_m = 121.0; },
             MatchStatus::kNoOverlap},
        Rule{"min_constraint_m",
             [](Case& c) { c.constraint.open_direction_m = 0.51; },
             [](Case& c) { c.constraint.open_direction_m = 0.49; },
             kDegenerate},
        Rule{"min_turning_m3",
             [](Case& c) { c.constraint.turning_m3 = 2.01; },
             [](Case& c) { c.constraint.turning_m3 = 1.99; },
             kDegenerate},
        Rule{"min_score",
             [](Case& c) { set_score(c, 0.25, 0.13); },
             [](Case& c) { set_score(c, 0.23, 0.11); },
             kAmbiguous},
        Rule{"min_margin",
             [](Case& c) { set_score(c, 0.5, 0.41); },
             [](Case& c) { set_score(c, 0.5, 0.43); },
             kAmbiguous},
        Rule{"min_score_alone",
             [](Case& c) {
               c.params.floor_score = -1.0;
               set_score(c, 0.06, -0.2);
             },
             [](Case& c) {
               c.params.floor_score = -1.0;
               set_score(c, 0.04, -0.2);
             },
             kAmbiguous},
        Rule{"min_margin_alone",
             [](Case& c) { set_score(c, 0.2, 0.04); },
             [](Case& c) { set_score(c, 0.2, 0.06); },
             kAmbiguous},
        Rule{"floor_score",  // A bottomless runner-up makes no margin for a low score.
             [](Case& c) {
               c.params.min_score_alone = 0.0;
               set_score(c, 0.055, -5.0);
             },
             [](Case& c) {
               c.params.min_score_alone = 0.0;
               set_score(c, 0.045, -5.0);
             },
             kAmbiguous},
        Rule{"min_wall_m",
             [](Case& c) {
               set_score(c, 0.29, 0.0);
               c.constraint.all_m = 3.1;
             },
             [](Case& c) {
               set_score(c, 0.29, 0.0);
               c.constraint.all_m = 2.9;
             },
             kAmbiguous},
        Rule{"margin_per_contradiction, forward",  // A margin of 0.4 suffers 0.348.
             [](Case& c) { c.two_way.forward = {.agreeing_m = 6.6, .contradicted_m = 3.4}; },
             [](Case& c) { c.two_way.forward = {.agreeing_m = 6.4, .contradicted_m = 3.6}; },
             kAmbiguous},
        Rule{"margin_per_contradiction, backward",
             [](Case& c) { c.two_way.backward = {.agreeing_m = 6.6, .contradicted_m = 3.4}; },
             [](Case& c) { c.two_way.backward = {.agreeing_m = 6.4, .contradicted_m = 3.6}; },
             kAmbiguous},
        Rule{"rival_agreement",
             [](Case& c) { set_rival(c, 8.1, 0.0); },
             [](Case& c) { set_rival(c, 8.2, 0.0); },
             kAmbiguous},
        Rule{"rival_contradiction",  // 0.2 of 12.2 m are contradicted in the answer.
             [](Case& c) { set_rival(c, 9.0, 9.0 * 0.0674 / (1 - 0.0674)); },
             [](Case& c) { set_rival(c, 9.0, 9.0 * 0.0654 / (1 - 0.0654)); },
             kAmbiguous},
        Rule{"rival_contradiction_m",  // Of a rival with enough wall to keep the share small.
             [](Case& c) { set_rival(c, 200.0, 2.3); },
             [](Case& c) { set_rival(c, 200.0, 2.1); },
             kAmbiguous},
        Rule{"min_distinct_m",
             [](Case& c) { c.distinct_wall_m = 1.81; },
             [](Case& c) { c.distinct_wall_m = 1.79; },
             kAmbiguous},
        Rule{"min_place_log_odds",
             [](Case& c) {
               c.params.min_place_log_odds = 3.0;
               c.place_log_odds = 3.01;
             },
             [](Case& c) {
               c.params.min_place_log_odds = 3.0;
               c.place_log_odds = 2.99;
             },
             kAmbiguous},
        Rule{"min_probability_by_rules",
             [](Case& c) { c.probability = c.params.min_probability_by_rules + 0.001; },
             [](Case& c) { c.probability = c.params.min_probability_by_rules - 0.001; },
             kAmbiguous},
        Rule{"min_probability",  // Where the rules of the score fail.
             [](Case& c) {
               set_score(c, 0.2, 0.15);
               c.probability = c.params.min_probability + 1e-5;
             },
             [](Case& c) {
               set_score(c, 0.2, 0.15);
               c.probability = c.params.min_probability - 1e-5;
             },
             kAmbiguous},
        Rule{"an alias",
             [](Case& c) { c.probability = 1.0; },
             [](Case& c) {
               c.probability = 1.0;
               c.num_aliases = 1;
             },
             kAmbiguous}));

TEST(Verdict, AProbableAnswerNeedsNoRuleOfTheScoreButHasNoRival) {
  Case c;
  c.probability = c.params.min_probability;
  set_score(c, 0.05, 0.0);
  c.two_way.forward = {.agreeing_m = 5.0, .contradicted_m = 5.0};
  c.distinct_wall_m = 0.5;
  c.constraint.all_m = 1.0;
  EXPECT_EQ(c.verdict(), MatchStatus::kMatched);
  set_rival(c, 11.0, 0.0);
  EXPECT_EQ(c.verdict(), MatchStatus::kAmbiguous);
}

TEST(Verdict, NoProbabilityIsNoMatch) {
  Case c;
  c.probability = std::nan("");
  EXPECT_EQ(c.verdict(), MatchStatus::kAmbiguous);
}

TEST(Verdict, ARivalWithinTheSameBasinIsNone) {
  Case c;
  set_rival(c, 11.9, 0.0);
  EXPECT_EQ(c.verdict(), MatchStatus::kAmbiguous);
  c.candidates[1].T_reference_current = {0.6, 0.2, 0.25};
  EXPECT_EQ(c.verdict(), MatchStatus::kMatched);
}

TEST(Verdict, AnyOfTheCandidatesMayBeTheRival) {
  Case c;
  c.candidates.push_back(c.candidates[1]);
  c.candidates.back().T_reference_current.y_m = -5.0;
  c.candidates.back().evidence = c.candidates[0].evidence;
  c.candidates.back().score = -0.3;
  EXPECT_EQ(c.verdict(), MatchStatus::kAmbiguous);
}

TEST(Verdict, OneCandidateAloneIsJudgedAgainstNothing) {
  Case c;
  c.candidates.resize(1);
  c.runner_up_score = 0.0;
  EXPECT_EQ(c.verdict(), MatchStatus::kMatched);
}

TEST(Verdict, WhatIsNotHeldIsDegenerateEvenWhereItIsAmbiguous) {
  Case c;
  c.constraint.open_direction_m = 0.0;
  c.distinct_wall_m = 0.0;
  set_score(c, 0.3, 0.3);
  EXPECT_EQ(c.verdict(), MatchStatus::kDegenerate);
}

TEST(Verdict, OfNoNumbersIsNoMatch) {
  Case c;
  c.candidates[0].evidence.agreeing_m = std::nan("");
  EXPECT_EQ(c.verdict(), MatchStatus::kNoOverlap);
}

/// The hessian of walls, each `length_m` long at `p_m`, that face a direction.
struct FacingWall {
  double length_m;
  Eigen::Vector2d p_m;
  double facing_rad;
};

Eigen::Matrix3d hessian_of(const std::vector<FacingWall>& walls) {
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
  for (const FacingWall& wall : walls) {
    const Eigen::Vector2d n(std::cos(wall.facing_rad), std::sin(wall.facing_rad));
    const Eigen::Vector3d j(n.x(), n.y(), n.y() * wall.p_m.x() - n.x() * wall.p_m.y());
    hessian += wall.length_m * j * j.transpose();
  }
  return hessian;
}

TEST(WallConstraint, GivesTheWeakestDirectionAndItsWall) {
  // Long walls face y at x = -2, 2; short ones face x at y = -1, 1.
  const std::vector<FacingWall> walls{{4.0, {-2, 1.5}, -0.5 * kPi},
                                      {4.0, {2, 1.5}, -0.5 * kPi},
                                      {0.5, {3, 1}, kPi},
                                      {0.5, {3, -1}, kPi}};
  const WallConstraint constraint = wall_constraint(hessian_of(walls));
  EXPECT_NEAR(constraint.open_direction_m, 1.0, 1e-9);
  EXPECT_NEAR(constraint.all_m, 9.0, 1e-9);
  EXPECT_NEAR(wrap_to_period(constraint.open_direction_rad, kPi), 0.0, 1e-9);
  EXPECT_NEAR(constraint.turning_m3, 8.0 * 4.0 + 1.0 * 1.0, 1e-3);
}

TEST(WallConstraint, ATurnOfTheFrameTurnsTheDirectionOnly) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<FacingWall> walls;
    for (int i = 0; i < 6; ++i) {
      const auto any = [&](double reach) { return testing::uniform(generator, -reach, reach); };
      walls.push_back({testing::uniform(generator, 0.5, 4.0), {any(5), any(5)}, any(kPi)});
    }
    const double turn_rad = testing::uniform(generator, -kPi, kPi);
    auto turned = walls;
    for (FacingWall& wall : turned) {
      wall.p_m = Pose2{0.0, 0.0, turn_rad} * wall.p_m;
      wall.facing_rad += turn_rad;
    }
    const WallConstraint before = wall_constraint(hessian_of(walls));
    const WallConstraint after = wall_constraint(hessian_of(turned));
    EXPECT_NEAR(after.open_direction_m, before.open_direction_m, 1e-9);
    EXPECT_NEAR(after.all_m, before.all_m, 1e-9);
    EXPECT_NEAR(after.turning_m3, before.turning_m3, 1e-3 * (1.0 + before.turning_m3));
    const double rest_rad = after.open_direction_rad - before.open_direction_rad - turn_rad;
    EXPECT_NEAR(wrap_to_period(rest_rad, kPi), 0.0, 1e-6);
  }
}

TEST(WallConstraint, ARoundHallHoldsNoRotationAndACorridorNoMotionAlongIt) {
  std::vector<FacingWall> hall;
  for (int i = 0; i < 360; ++i) {
    const double bearing_rad = rad_from_deg(i);
    const Eigen::Vector2d middle_m(1.0, -0.5);  // The sensor need not be there.
    const Eigen::Vector2d p_m =
        middle_m + 4.0 * Eigen::Vector2d(std::cos(bearing_rad), std::sin(bearing_rad));
    hall.push_back({0.07, p_m, bearing_rad + kPi});
  }
  const WallConstraint round = wall_constraint(hessian_of(hall));
  EXPECT_NEAR(round.turning_m3, 0.0, 1e-3);
  const WallConstraint corridor =
      wall_constraint(hessian_of({{9.0, {-3, 1}, -0.5 * kPi}, {9.0, {3, -1}, 0.5 * kPi}}));
  EXPECT_NEAR(corridor.open_direction_m, 0.0, 1e-9);
  EXPECT_GT(corridor.turning_m3, 50.0);
}

}  // namespace setsquare::match_verdict_test
