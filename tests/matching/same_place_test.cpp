// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A corridor's side and its end lie on each other in any two buildings; where the walls end tells.
#include "setsquare/matching/same_place.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "setsquare/matching/scan_matcher.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::same_place_test {

using testing::Wall;

constexpr testing::Fan kHalfTurn{181, -kPi / 2.0, kPi / 180.0};

PreparedScan look(const std::vector<Wall>& walls, const Pose2& T, std::uint64_t seed) {
  return prepare(testing::scan_of_walls(walls, T, kHalfTurn, 0.01, seed));
}

bool is_matched(const PreparedScan& a, const PreparedScan& b, double min_place_log_odds) {
  MatchParams params;
  params.answer.min_place_log_odds = min_place_log_odds;
  return match(a, b, params).status == MatchStatus::kMatched;
}

TEST(SamePlace, EndsOfTwoCorridorsAreTakenForOneLessOftenThanWithoutTheRule) {
  constexpr double kOff = -std::numeric_limits<double>::infinity();
  constexpr int kNumPairs = 400;
  auto generator = testing::make_generator();
  int of_two = 0;
  int of_two_without = 0;
  int of_one = 0;
  int of_one_without = 0;
  for (int k = 0; k < kNumPairs; ++k) {
    const auto one = testing::end_of_a_corridor(generator);
    const auto other = testing::end_of_a_corridor(generator);
    const Pose2 a = testing::pose_before_the_end(generator);
    const Pose2 b = testing::pose_before_the_end(generator);
    const PreparedScan reference = look(one, a, generator());
    const PreparedScan elsewhere = look(other, b, generator());
    const PreparedScan here = look(one, b, generator());
    if (is_matched(reference, elsewhere, kOff)) {
      ++of_two_without;
      of_two += is_matched(reference, elsewhere, kOnePlaceLogOdds);
    }
    if (is_matched(reference, here, kOff)) {
      ++of_one_without;
      of_one += is_matched(reference, here, kOnePlaceLogOdds);
    }
  }
  EXPECT_GE(of_two_without, kNumPairs / 20);
  EXPECT_LE(of_two, 0.85 * of_two_without);
  EXPECT_GE(of_one_without, kNumPairs / 2);
  EXPECT_GE(of_one, 0.97 * of_one_without);
}

/// Evidence of an answer that might be of another place.
PlaceEvidence some_evidence() {
  return {.log_odds = 6.0,
          .ends = {.agreeing = 3, .missing = 4},
          .close_distinct_m = 2.0,
          .unexplained_share = 0.1,
          .normal_rms_rad = 0.15,
          .turning_m3 = 10.0,
          .narrow_spread_m = 0.8};
}

TEST(SamePlace, WhatSpeaksForOnePlaceRaisesTheOdds) {
  const double before = place_log_odds(some_evidence());
  const auto changed = [](auto&& change) {
    PlaceEvidence evidence = some_evidence();
    change(evidence);
    return place_log_odds(evidence);
  };
  EXPECT_GT(changed([](auto& e) { e.log_odds += 1.0; }), before);
  EXPECT_GT(changed([](auto& e) { ++e.ends.agreeing; }), before);
  EXPECT_LT(changed([](auto& e) { ++e.ends.missing; }), before);
  EXPECT_GT(changed([](auto& e) { e.close_distinct_m += 0.5; }), before);
  EXPECT_LT(changed([](auto& e) { e.unexplained_share += 0.1; }), before);
  EXPECT_LT(changed([](auto& e) { e.normal_rms_rad += 0.05; }), before);
  EXPECT_GT(changed([](auto& e) { e.narrow_spread_m += 0.5; }), before);
}

// A wall with a doorway 1 m wide, 2 m before the sensor, in a room behind.
const std::vector<Wall> kDoorway = {
    {2.0, -4.0, 2.0, -0.5}, {2.0, 0.5, 2.0, 4.0}, {5.0, -4.0, 5.0, 4.0}};

TEST(WallEnds, AreTheJambsOfADoorway) {
  const PreparedScan scan = look(kDoorway, {0.0, 0.0, 0.0}, 1);
  const auto ends = wall_ends(scan.points());
  int num_jambs = 0;
  for (const WallEnd& end : ends) {
    const bool is_right = (end.at_m - Eigen::Vector2d(2.0, -0.5)).norm() < 0.1;
    const bool is_left = (end.at_m - Eigen::Vector2d(2.0, 0.5)).norm() < 0.1;
    if (is_right) {
      EXPECT_LT(end.into_wall.y(), -0.9);
    }
    if (is_left) {
      EXPECT_GT(end.into_wall.y(), 0.9);
    }
    num_jambs += is_right || is_left;
  }
  EXPECT_EQ(num_jambs, 2);
}

TEST(WallEnds, AgreeWhereBothScansSeeThemAndMissWhereOneSeesAWall) {
  const PreparedScan scan = look(kDoorway, {0.0, 0.0, 0.0}, 1);
  const PreparedScan nearer = look(kDoorway, {0.5, 0.3, 0.1}, 2);
  const WallEndCount same = compare_wall_ends(scan, nearer, {0.5, 0.3, 0.1});
  EXPECT_GE(same.agreeing, 4U);
  EXPECT_EQ(same.missing, 0U);
  const PreparedScan without = look({{2.0, -4.0, 2.0, 4.0}}, {0.5, 0.3, 0.1}, 2);
  const WallEndCount other = compare_wall_ends(scan, without, {0.5, 0.3, 0.1});
  EXPECT_EQ(other.agreeing, 0U);
  EXPECT_GE(other.missing, 2U);
}

}  // namespace setsquare::same_place_test
