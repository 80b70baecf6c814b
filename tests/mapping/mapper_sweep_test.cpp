// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A log whose scans are skewed by the robot's turns, with right, wrong and no sweep times.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "tests/support/spin.hpp"

namespace setsquare::mapper_sweep_test {

using testing::scans_of_spin;
using testing::Spin;
using testing::SpunScan;

Map map_of(const std::vector<SpunScan>& scans) {
  Mapper mapper;
  for (const SpunScan& spun : scans) mapper.add(spun.scan);
  return mapper.finish();
}

/// Of the last scan against the first, in deg.
double heading_error_deg(const Map& map, const std::vector<SpunScan>& scans) {
  const double turned_rad =
      map.scans.back().T_map_sensor.theta_rad - map.scans.front().T_map_sensor.theta_rad;
  return std::abs(deg_from_rad(wrap_to_pi(turned_rad - scans.back().turn_rad)));
}

TEST(MapperSweep, StatedTimesAreUsed) {
  const auto scans = scans_of_spin({.turn_deg_per_s = 180.0}, 11);
  const Map map = map_of(scans);
  EXPECT_EQ(map.sweep.verdict, SweepVerdict::kStated);
  EXPECT_NEAR(map.sweep.sweep_s, 359.0 / 360.0 / 7.0, 1e-9);
  EXPECT_LT(heading_error_deg(map, scans), 0.5);
}

TEST(MapperSweep, TimesThatTheLogDoesNotStateAreFound) {
  for (std::uint64_t seed = 11; seed <= 13; ++seed) {
    const auto scans =
        scans_of_spin({.turn_deg_per_s = 180.0, .sweep_share = -1.0, .states_sweep = false}, seed);
    const Map map = map_of(scans);
    EXPECT_EQ(map.scans.size(), scans.size());
    EXPECT_EQ(map.sweep.verdict, SweepVerdict::kFound) << seed;
    EXPECT_LT(map.sweep.sweep_s, 0.0) << seed;
    EXPECT_LT(heading_error_deg(map, scans), 0.5) << seed;
  }
}

/// A driver that states its beams in the wrong order.
TEST(MapperSweep, TimesThatTheWallsContradictAreNotBelieved) {
  auto scans = scans_of_spin({.turn_deg_per_s = 180.0}, 11);
  for (SpunScan& spun : scans) spun.scan.time_increment_s = -spun.scan.time_increment_s;
  const Map map = map_of(scans);
  EXPECT_EQ(map.sweep.verdict, SweepVerdict::kFound);
  EXPECT_LT(map.sweep.stated_s, 0.0);
  EXPECT_GT(map.sweep.sweep_s, 0.0);
  EXPECT_LT(heading_error_deg(map, scans), 0.5);
}

/// Without a turn nothing is known of a scanner that spins: its driver may state the wrong order.
TEST(MapperSweep, StatedTimesThatNoTurnConfirmsAreNotUsed) {
  const auto scans = scans_of_spin({.num_turns = 0.0}, 11);
  const Map map = map_of(scans);
  EXPECT_EQ(map.sweep.verdict, SweepVerdict::kUnknown);
  EXPECT_GT(map.sweep.stated_s, 0.0);
  for (const KeptScan& kept : map.kept_scans) {
    EXPECT_EQ(kept.scan->ranges_m, scans[kept.index].scan.ranges_m);
  }
}

TEST(MapperSweep, ScansMeasuredAtOnceStayAsTheyAre) {
  auto scans =
      scans_of_spin({.turn_deg_per_s = 90.0, .sweep_share = 0.0, .states_sweep = false}, 11);
  const Map map = map_of(scans);
  EXPECT_EQ(map.sweep.verdict, SweepVerdict::kAtOnce);
  EXPECT_LT(heading_error_deg(map, scans), 0.5);
  for (const KeptScan& kept : map.kept_scans) {
    EXPECT_EQ(kept.scan->ranges_m, scans[kept.index].scan.ranges_m);
  }
}

TEST(MapperSweep, WhatTheMapKeepsIsDeskewed) {
  const auto scans = scans_of_spin({.turn_deg_per_s = 180.0}, 11);
  const Map map = map_of(scans);
  bool is_any_changed = false;
  for (const KeptScan& kept : map.kept_scans) {
    is_any_changed = is_any_changed || kept.scan->ranges_m != scans[kept.index].scan.ranges_m;
  }
  EXPECT_TRUE(is_any_changed);
}

}  // namespace setsquare::mapper_sweep_test
