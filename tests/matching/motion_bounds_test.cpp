// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "setsquare/matching/scan_matcher.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::motion_bounds_test {

using testing::PoseNear;
using testing::PoseTolerance;

const testing::Fan kFullTurn{360, rad_from_deg(-180), rad_from_deg(1)};

MatchParams within(double max_translation_m, double max_rotation_rad) {
  MatchParams params;
  params.bounds = {max_translation_m, max_rotation_rad};
  return params;
}

/// A square room: it looks the same after each quarter turn.
std::vector<testing::Wall> square_room() {
  return testing::closed_polygon({{-4, -4}, {4, -4}, {4, 4}, {-4, 4}});
}

TEST(MotionBounds, TellAQuarterTurnFromNone) {
  std::mt19937_64 random = testing::make_generator();
  for (int trial = 0; trial < 10; ++trial) {
    const Pose2 T_world_a{testing::uniform(random, -2, 2), testing::uniform(random, -2, 2), 0.3};
    const Pose2 moved{testing::uniform(random, -0.2, 0.2),
                      testing::uniform(random, -0.2, 0.2),
                      testing::uniform(random, -0.7, 0.7)};
    const Scan a = testing::scan_of_walls(square_room(), T_world_a, kFullTurn, 0.005, 11);
    const Scan b = testing::scan_of_walls(square_room(), T_world_a * moved, kFullTurn, 0.005, 12);
    EXPECT_EQ(match(a, b).status, MatchStatus::kAmbiguous);
    const MatchResult bounded = match(a, b, within(0.3, rad_from_deg(45.0)));
    EXPECT_EQ(bounded.status, MatchStatus::kMatched);
    ASSERT_TRUE(bounded.T_reference_current.has_value());
    EXPECT_THAT(*bounded.T_reference_current, PoseNear(moved, PoseTolerance{0.02, 0.005}));
  }
}

TEST(MotionBounds, ThatHoldTheAnswerDoNotChangeIt) {
  const auto room = testing::l_shaped_room();
  const Scan a = testing::scan_of_walls(room, {2, 2, 0}, kFullTurn, 0.005, 11);
  const Scan b = testing::scan_of_walls(room, {2.5, 1.8, 0.4}, kFullTurn, 0.005, 12);
  const MatchResult free = match(a, b);
  const MatchResult bounded = match(a, b, within(1.0, 0.5));
  ASSERT_TRUE(free.T_reference_current && bounded.T_reference_current);
  EXPECT_THAT(*bounded.T_reference_current,
              PoseNear(*free.T_reference_current, PoseTolerance{0.002, 0.001}));
}

TEST(MotionBounds, ThatExcludeTheAnswerGiveNone) {
  const auto room = testing::l_shaped_room();
  const Scan a = testing::scan_of_walls(room, {2, 2, 0}, kFullTurn, 0.005, 11);
  const Scan b = testing::scan_of_walls(room, {2, 2, 2.0}, kFullTurn, 0.005, 12);
  EXPECT_EQ(match(a, b).status, MatchStatus::kMatched);
  EXPECT_NE(match(a, b, within(0.2, 0.3)).status, MatchStatus::kMatched);
}

/// Nearly round: a scan with noise is turned far by a step of its refinement.
TEST(MotionBounds, HoldWhereverRefinementLeads) {
  std::mt19937_64 random = testing::make_generator();
  const MatchParams params = within(0.3, rad_from_deg(20.0));
  int num_answers = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Eigen::Vector2d> corners;
    const int num_corners = 7 + trial % 8;
    for (int k = 0; k < num_corners; ++k) {
      const double bearing_rad = 2.0 * kPi * k / num_corners;
      const double radius_m = testing::uniform(random, 2.9, 3.1);
      corners.emplace_back(radius_m * std::cos(bearing_rad), radius_m * std::sin(bearing_rad));
    }
    const auto hall = testing::closed_polygon(corners);
    const Pose2 T_world_a{testing::uniform(random, -1, 1), testing::uniform(random, -1, 1), 0.3};
    const Pose2 moved{0.1, -0.1, rad_from_deg(testing::uniform(random, -20, 20))};
    const std::uint64_t seed = 100 + 2 * static_cast<std::uint64_t>(trial);
    const Scan a = testing::scan_of_walls(hall, T_world_a, kFullTurn, 0.2, seed);
    const Scan b = testing::scan_of_walls(hall, T_world_a * moved, kFullTurn, 0.2, seed + 1);
    const MatchResult bounded = match(a, b, params);
    if (!bounded.T_reference_current) continue;
    ++num_answers;
    EXPECT_TRUE(params.bounds.may_hold(*bounded.T_reference_current))
        << trial << ": " << bounded.T_reference_current->translation().norm() << " m, "
        << deg_from_rad(bounded.T_reference_current->theta_rad) << " deg";
  }
  EXPECT_GT(num_answers, 100);
}

}  // namespace setsquare::motion_bounds_test
