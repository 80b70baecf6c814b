// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Where the scans do not determine the answer, the matcher says so.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "setsquare/core/symmetric_eigen.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::scan_matcher_honesty_test {

using testing::Fan;
using testing::PoseNear;
using testing::PoseTolerance;
using testing::scan_of_walls;
using testing::uniform;

const Fan kHalfTurn{361, rad_from_deg(-90), rad_from_deg(0.5)};
const Fan kFullTurn{720, rad_from_deg(-180), rad_from_deg(0.5)};
constexpr PoseTolerance kNear{.translation_m = 0.03, .rotation_rad = rad_from_deg(0.5)};

TEST(HonestMatch, ACorridorHasExactlyOneDegenerateDirectionAlongIt) {
  auto generator = testing::make_generator();
  const auto corridor = testing::endless_corridor();
  for (int trial = 0; trial < 30; ++trial) {
    const Pose2 T_world_reference{0.0, uniform(generator, 0.5, 1.9), uniform(generator, -kPi, kPi)};
    const Pose2 T_reference_current{
        uniform(generator, -0.3, 0.3), uniform(generator, -0.3, 0.3), uniform(generator, -1, 1)};
    const Pose2 T_world_current = T_world_reference * T_reference_current;
    const auto scan = [&](const Pose2& T, std::uint64_t seed) {
      return scan_of_walls(corridor, T, trial % 2 ? kFullTurn : kHalfTurn, 0.01, seed);
    };
    const MatchResult result = match(scan(T_world_reference, 1), scan(T_world_current, 2));
    EXPECT_EQ(result.status, MatchStatus::kDegenerate) << to_string(result.status);
    if (!result.degenerate_direction_rad) continue;
    const double along_rad = -T_world_reference.theta_rad;
    EXPECT_NEAR(
        wrap_to_period(*result.degenerate_direction_rad - along_rad, kPi), 0.0, rad_from_deg(2.0));
    // The information shows it, too: almost nothing along, plenty across and in rotation.
    Eigen::Matrix3d to_corridor = Eigen::Matrix3d::Identity();
    to_corridor.topLeftCorner<2, 2>() =
        Eigen::Rotation2Dd(T_world_reference.theta_rad).toRotationMatrix();
    const Eigen::Matrix3d information = to_corridor * result.information * to_corridor.transpose();
    EXPECT_LT(information(0, 0), 0.05 * information(1, 1));
    const Eigen::Matrix2d determined = information.bottomRightCorner<2, 2>();
    EXPECT_GT(symmetric_eigenvalues(determined)(0), 100.0);
    // Across the corridor the answer holds, up to the half turn that a bare corridor allows.
    ASSERT_TRUE(result.T_reference_current.has_value());
    const Pose2 T_world_found = T_world_reference * *result.T_reference_current;
    const bool is_turned =
        std::abs(wrap_to_pi(T_world_found.theta_rad - T_world_current.theta_rad)) > 1.0;
    EXPECT_NEAR(
        T_world_found.y_m, is_turned ? 2.4 - T_world_current.y_m : T_world_current.y_m, 0.03);
  }
}

TEST(HonestMatch, ACorridorsDoorwayEndsTheDegeneracy) {
  std::vector<testing::Wall> corridor = {{-90, 0.0, 90, 0.0},
                                         {-90, 2.4, -0.6, 2.4},
                                         {0.6, 2.4, 2.9, 2.4},
                                         {-0.6, 2.4, -0.6, 3.2},
                                         {0.6, 2.4, 0.6, 3.2},
                                         {-0.6, 3.2, 0.6, 3.2},
                                         {2.9, 2.4, 2.9, 2.9},
                                         {2.9, 2.9, 90, 2.9}};
  const Pose2 T_world_reference{-0.4, 1.0, 0.3};
  const Pose2 T_world_current{0.5, 1.3, 0.7};
  const MatchResult result = match(scan_of_walls(corridor, T_world_reference, kFullTurn, 0.01, 1),
                                   scan_of_walls(corridor, T_world_current, kFullTurn, 0.01, 2));
  EXPECT_EQ(result.status, MatchStatus::kMatched);
  EXPECT_THAT(*result.T_reference_current,
              PoseNear(T_world_reference.inverse() * T_world_current, kNear));
  EXPECT_FALSE(result.degenerate_direction_rad.has_value());
}

TEST(HonestMatch, AnOpenFieldHasTooFewPoints) {
  const Scan field = scan_of_walls({}, {}, kFullTurn);
  const Scan room = scan_of_walls(testing::l_shaped_room(), {2, 2, 0}, kFullTurn);
  const std::vector<testing::Wall> post = {{3.0, -0.03, 3.0, 0.03}};
  const Scan post_alone = scan_of_walls(post, {}, kFullTurn);
  for (const auto& [a, b] : {std::pair{field, field},
                             std::pair{room, field},
                             std::pair{field, room},
                             std::pair{post_alone, room}}) {
    const MatchResult result = match(a, b);
    EXPECT_EQ(result.status, MatchStatus::kTooFewPoints);
    EXPECT_FALSE(result.T_reference_current.has_value());
  }
}

TEST(HonestMatch, ARoundRoomDeterminesNoHeading) {
  const auto room = testing::regular_polygon(240, 3.0);
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 10; ++trial) {
    const auto scan = [&](std::uint64_t seed) {
      const Pose2 T{
          uniform(generator, -1, 1), uniform(generator, -1, 1), uniform(generator, -3, 3)};
      return scan_of_walls(room, T, kFullTurn, 0.01, seed);
    };
    // Only the rotation is unbound, so no direction is reported.
    const MatchResult result = match(scan(1), scan(2));
    EXPECT_TRUE(result.status == MatchStatus::kDegenerate ||
                result.status == MatchStatus::kAmbiguous)
        << to_string(result.status);
    EXPECT_FALSE(result.degenerate_direction_rad.has_value());
  }
}

TEST(HonestMatch, AnEmptyRectangleAllowsTheHalfTurn) {
  constexpr double kWidth_m = 5.0;
  constexpr double kHeight_m = 3.4;
  const auto room = testing::empty_rectangle(kWidth_m, kHeight_m);
  const Pose2 half_turn{kWidth_m, kHeight_m, -kPi};  // About the room's middle.
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 20; ++trial) {
    const auto pose = [&] {
      return Pose2{
          uniform(generator, 0.6, 4.4), uniform(generator, 0.6, 2.8), uniform(generator, -3, 3)};
    };
    const Pose2 T_world_reference = pose();
    const Pose2 T_world_current = pose();
    const MatchResult result = match(scan_of_walls(room, T_world_reference, kFullTurn, 0.01, 1),
                                     scan_of_walls(room, T_world_current, kFullTurn, 0.01, 2));
    EXPECT_EQ(result.status, MatchStatus::kAmbiguous);
    ASSERT_TRUE(result.T_reference_current.has_value());
    ASSERT_TRUE(result.runner_up.has_value());
    Pose2 straight = T_world_reference.inverse() * T_world_current;
    Pose2 turned = T_world_reference.inverse() * half_turn * T_world_current;
    if (std::abs(wrap_to_pi(result.T_reference_current->theta_rad - straight.theta_rad)) > 1.0) {
      std::swap(straight, turned);
    }
    EXPECT_THAT(*result.T_reference_current, PoseNear(straight, kNear));
    // The runner-up is not refined to the last.
    constexpr PoseTolerance kRoughly{.translation_m = 0.08, .rotation_rad = rad_from_deg(2.0)};
    EXPECT_THAT(result.runner_up->T_reference_current, PoseNear(turned, kRoughly));
  }
}

// Three long walls have one pose in this room and fit many another: whether that stands as a match
// may be judged either way, but the pose is right.
TEST(HonestMatch, ABareTriangleIsFoundOrAmbiguous) {
  const auto room = testing::closed_polygon({{-3, -2}, {4, -1}, {0.5, 5}});
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 20; ++trial) {
    const auto pose = [&] {
      return Pose2{
          uniform(generator, -0.5, 1.0), uniform(generator, -0.5, 1.5), uniform(generator, -3, 3)};
    };
    const Pose2 T_world_reference = pose();
    const Pose2 T_world_current = pose();
    const MatchResult result = match(scan_of_walls(room, T_world_reference, kFullTurn, 0.01, 1),
                                     scan_of_walls(room, T_world_current, kFullTurn, 0.01, 2));
    EXPECT_TRUE(result.status == MatchStatus::kMatched || result.status == MatchStatus::kAmbiguous)
        << to_string(result.status);
    EXPECT_THAT(*result.T_reference_current,
                PoseNear(T_world_reference.inverse() * T_world_current, kNear));
  }
}

/// A wall with a pilaster every two metres, that the sensor sees from one side.
std::vector<testing::Wall> row_of_pilasters() {
  constexpr double kDepth_m = 0.25;
  std::vector<testing::Wall> walls;
  for (int k = -20; k < 20; ++k) {
    const double x_m = 2.0 * k;
    walls.insert(walls.end(),
                 {{x_m, 0.0, x_m + 1.4, 0.0},
                  {x_m + 1.4, 0.0, x_m + 1.4, -kDepth_m},
                  {x_m + 1.4, -kDepth_m, x_m + 2.0, -kDepth_m},
                  {x_m + 2.0, -kDepth_m, x_m + 2.0, 0.0}});
  }
  return walls;
}

// Half way between two answers: neither is accepted, and the twin is reported.
TEST(HonestMatch, ATwinInARowIsTheRunnerUp) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 20; ++trial) {
    const double x_m = uniform(generator, -1.0, 1.0);
    const double sign = trial % 2 == 0 ? 1.0 : -1.0;
    const Pose2 T_world_reference{x_m, -2.0, 0.5 * kPi};
    const Pose2 T_world_current{x_m + sign * uniform(generator, 0.98, 1.02), -2.1, 0.5 * kPi};
    const MatchResult result =
        match(scan_of_walls(row_of_pilasters(), T_world_reference, kHalfTurn, 0.01, 1),
              scan_of_walls(row_of_pilasters(), T_world_current, kHalfTurn, 0.01, 2));
    EXPECT_EQ(result.status, MatchStatus::kAmbiguous) << to_string(result.status);
    ASSERT_TRUE(result.T_reference_current.has_value());
    ASSERT_TRUE(result.runner_up.has_value());
    EXPECT_GT(result.runner_up->score, 0.7 * result.score);
    // Whichever the answer and the runner-up chose, they are two of the row.
    const Pose2 T_world_found = T_world_reference * *result.T_reference_current;
    const Pose2 T_world_other = T_world_reference * result.runner_up->T_reference_current;
    for (const Pose2& T : {T_world_found, T_world_other}) {
      EXPECT_NEAR(wrap_to_period(T.x_m - T_world_current.x_m, 2.0), 0.0, 0.05);
      EXPECT_NEAR(T.y_m, T_world_current.y_m, 0.05);
    }
    EXPECT_GT(std::abs(T_world_other.x_m - T_world_found.x_m), 1.5);
  }
}

TEST(HonestMatch, ARegularHexagonIsNotMatchedToAnyOfItsTurns) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 10; ++trial) {
    const auto scan = [&](std::uint64_t seed) {
      const Pose2 T{
          uniform(generator, -1, 1), uniform(generator, -1, 1), uniform(generator, -3, 3)};
      return scan_of_walls(testing::regular_polygon(6, 3.5), T, kFullTurn, 0.01, seed);
    };
    EXPECT_EQ(match(scan(1), scan(2)).status, MatchStatus::kAmbiguous);
  }
}

// The corners of two rectangles look the same: half a turn's view cannot distinguish such rooms.
// A full turn's view shows the room's size, and then a match of two rooms is rare.
TEST(HonestMatch, RoomsThatHaveNothingInCommonAreSeldomMatched) {
  auto generator = testing::make_generator();
  int num_matched = 0;
  constexpr int kNumTrials = 150;
  for (int trial = 0; trial < kNumTrials; ++trial) {
    const auto scan = [&] {
      const auto room = testing::furnished_room(generator);
      return scan_of_walls(
          room.walls, testing::free_pose(room, generator), kFullTurn, 0.01, generator());
    };
    num_matched += match(scan(), scan()).status == MatchStatus::kMatched;
  }
  std::cout << "different rooms matched: " << num_matched << " of " << kNumTrials << "\n";
  EXPECT_LE(num_matched, kNumTrials * 2 / 100);
}

}  // namespace setsquare::scan_matcher_honesty_test
