// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/sensing/person.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace setsquare::person_test {

Eigen::Vector2d middle_of(const std::vector<Disc>& legs) {
  return 0.5 * (legs[0].center_m + legs[1].center_m);
}

TEST(LegsTest, WalksToAndFro) {
  const std::vector<Person> people{{{1.0, 2.0}, {4.0, 6.0}, 2.0, 0.5}};  // 5 m: 2.5 s a way.
  const auto expect_at = [&](double time_s, const Eigen::Vector2d& expected_m) {
    const std::vector<Disc> legs = legs_at(people, time_s);
    ASSERT_EQ(legs.size(), 2u);
    EXPECT_NEAR((middle_of(legs) - expected_m).norm(), 0.0, 1e-9) << time_s;
  };
  expect_at(0.5, {1.0, 2.0});
  expect_at(0.5 + 1.25, {2.5, 4.0});
  expect_at(0.5 + 2.5, {4.0, 6.0});
  expect_at(0.5 + 3.75, {2.5, 4.0});
  expect_at(0.5 - 1.25, {2.5, 4.0});
  expect_at(0.5 + 50.0, {1.0, 2.0});
}

TEST(LegsTest, LegsNeverJumpNorTouch) {
  const std::vector<Person> people{{{0.0, 0.0}, {3.1, 0.7}, 1.2, 0.0}};
  constexpr double kStep_s = 1e-3;
  double widest_m = 0.0;
  for (double time_s = -8.0; time_s < 8.0; time_s += kStep_s) {
    const auto now = legs_at(people, time_s);
    const auto next = legs_at(people, time_s + kStep_s);
    for (int leg = 0; leg < 2; ++leg) {
      const double moved_m = (next[leg].center_m - now[leg].center_m).norm();
      ASSERT_LT(moved_m, 4.0 * 1.2 * kStep_s) << time_s;
    }
    const double apart_m = (now[0].center_m - now[1].center_m).norm();
    ASSERT_GT(apart_m, now[0].radius_m + now[1].radius_m);
    widest_m = std::max(widest_m, apart_m);
  }
  EXPECT_GT(widest_m, 0.4) << "a stride";
}

TEST(LegsTest, AStandingPersonStaysInPlace) {
  const std::vector<Person> people{{{1.0, 1.0}, {1.0, 1.0}}, {{0.0, 0.0}, {5.0, 0.0}, 0.0}};
  const auto early = legs_at(people, 0.0);
  const auto late = legs_at(people, 33.3);
  ASSERT_EQ(early.size(), 4u);
  for (int leg = 0; leg < 4; ++leg) EXPECT_EQ(early[leg].center_m, late[leg].center_m);
}

}  // namespace setsquare::person_test
