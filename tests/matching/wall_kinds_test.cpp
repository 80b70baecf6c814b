// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/wall_kinds.hpp"

#include <gtest/gtest.h>

#include "setsquare/surfaces/prepared_scan.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::wall_kinds_test {

const testing::Fan kFullTurn{720, -kPi, rad_from_deg(0.5)};

PreparedScan prepared(const std::vector<testing::Wall>& walls, const Pose2& T) {
  return prepare(testing::scan_of_walls(walls, T, kFullTurn));
}

TwoWayKinds kinds_of(const PreparedScan& a, const PreparedScan& b, const Pose2& T_a_b) {
  return wall_kinds(a.fine_alignment(), b.fine_alignment(), T_a_b);
}

TEST(WallKinds, OfAScanOnItselfAgreeClosely) {
  const PreparedScan scan = prepared(testing::l_shaped_room(), {2.0, 2.5, 0.3});
  const WallKinds kinds = kinds_of(scan, scan, {}).forward;
  EXPECT_GT(kinds.tight_m, 0.9 * kinds.wall_m);
  EXPECT_EQ(kinds.contradicted_m, 0.0);
  EXPECT_EQ(kinds.unexplained_m, 0.0);
}

TEST(WallKinds, EveryPieceIsOfOneKindAtMost) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 30; ++trial) {
    const auto room = testing::furnished_room(generator);
    const PreparedScan a = prepared(room.walls, testing::free_pose(room, generator));
    const PreparedScan b = prepared(room.walls, testing::free_pose(room, generator));
    const Pose2 T{testing::uniform(generator, -3.0, 3.0),
                  testing::uniform(generator, -3.0, 3.0),
                  testing::uniform(generator, -kPi, kPi)};
    const TwoWayKinds both = kinds_of(a, b, T);
    const TwoWayKinds turned = kinds_of(b, a, T.inverse());
    EXPECT_NEAR(both.forward.hidden_m, turned.backward.hidden_m, 0.3);
    for (const WallKinds& kinds : {both.forward, both.backward}) {
      EXPECT_LE(kinds.tight_m, kinds.loose_m);
      const double sum_m = kinds.loose_m + kinds.clutter_m + kinds.contradicted_m + kinds.hidden_m +
                           kinds.unexplained_m + kinds.outside_m;
      EXPECT_LE(sum_m, kinds.wall_m * (1.0 + 1e-6));
    }
  }
}

/// A room of 6 m by 6 m about the origin, and a screen before the wall at x = 3.
std::vector<testing::Wall> room_with_screen(bool has_screen) {
  auto walls = testing::closed_polygon({{-3, -3}, {3, -3}, {3, 3}, {-3, 3}});
  if (has_screen) walls.push_back({1.5, -1.0, 1.5, 1.0});
  return walls;
}

// The wall behind the screen: from beside it the current scan sees it, the reference does not.
TEST(WallKinds, WallBehindSomethingIsExplainedOnlyWhereBothSawIt) {
  const Pose2 T_world_reference{0.0, 0.0, 0.0};
  const Pose2 T_world_current{1.0, 2.4, 0.0};
  const Pose2 T = T_world_reference.inverse() * T_world_current;
  const PreparedScan reference = prepared(room_with_screen(true), T_world_reference);
  const PreparedScan sees_it = prepared(room_with_screen(true), T_world_current);
  const PreparedScan after_it_went = prepared(room_with_screen(false), T_world_current);
  const WallKinds explained = kinds_of(reference, sees_it, T).forward;
  EXPECT_GT(explained.hidden_m, 0.5);
  EXPECT_LT(explained.unexplained_m, 0.3 * explained.hidden_m);
  const WallKinds unexplained = kinds_of(reference, after_it_went, T).forward;
  EXPECT_GT(unexplained.unexplained_m, 0.5);
  EXPECT_LT(unexplained.hidden_m, 0.3 * unexplained.unexplained_m);
}

}  // namespace setsquare::wall_kinds_test
