// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Memory that the building bounds when a map is gone on with day after day.
#include "setsquare/mapping/known_sessions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "setsquare/map/map_summary.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "tests/mapping/tracked_world.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::known_sessions_test {

using testing::PoseNear;
using testing::PoseTolerance;
using testing::Wall;

constexpr double kNoise_m = 0.01;
constexpr double kStep_m = 0.2;
constexpr std::int64_t kDay_ns = 1'000'000'000'000;
const PoseTolerance kSame{.translation_m = 0.03, .rotation_rad = rad_from_deg(0.3)};

/// A robot that goes around the block each day, and a side more, from another corner.
struct Day {
  std::vector<Pose2> truth;
  std::vector<Scan> scans;
};

Day day_of(std::size_t number,
           std::size_t first_corner,
           std::size_t num_sides,
           const std::vector<Wall>& walls = testing::corridor_around_a_block()) {
  const std::array<Eigen::Vector2d, 4> corners{
      Eigen::Vector2d{1.0, 1.0}, {15.0, 1.0}, {15.0, 11.0}, {1.0, 11.0}};
  std::vector<Eigen::Vector2d> way;
  for (std::size_t i = 0; i <= num_sides; ++i) way.push_back(corners[(first_corner + i) % 4]);
  Day day{.truth = testing::drive(way, kStep_m, rad_from_deg(8.0)), .scans = {}};
  for (std::size_t i = 0; i < day.truth.size(); ++i) {
    day.scans.push_back(testing::scan_of_walls(
        walls, day.truth[i], testing::kAllAround, kNoise_m, 100'000 * (number + 1) + i));
    day.scans.back().stamp.ns =
        static_cast<std::int64_t>(number) * kDay_ns + static_cast<std::int64_t>(i) * 100'000'000;
  }
  return day;
}

std::vector<Day> days_at_random(std::size_t num) {
  auto generator = testing::make_generator();
  std::vector<Day> days;
  for (std::size_t d = 0; d < num; ++d) {
    const auto corner =
        d == 0 ? 0 : static_cast<std::size_t>(testing::uniform(generator, 0.0, 4.0));
    days.push_back(day_of(d, corner % 4, 5));
  }
  return days;
}

MapperParams params_of(bool forgets, std::size_t num_threads = 1) {
  MapperParams params;
  params.forgetting.is_on = forgets;
  params.audit.is_on = false;
  params.num_threads = num_threads;
  return params;
}

Map gone_on(const std::optional<Map>& map, const Day& day, const MapperParams& params) {
  Mapper mapper = map ? Mapper(*map, params) : Mapper(params);
  for (const Scan& scan : day.scans) mapper.add(scan);
  return mapper.finish();
}

/// The map after each day.
std::vector<Map> maps_of(std::span<const Day> days, const MapperParams& params) {
  std::vector<Map> maps;
  for (const Day& day : days) {
    maps.push_back(gone_on(maps.empty() ? std::nullopt : std::optional(maps.back()), day, params));
  }
  return maps;
}

/// Root mean square of the positions' errors; poses are those seen from the first.
double error_m(const Map& map, std::span<const Day> days) {
  const auto true_pose = [&](const MappedScan& scan) {
    const Day& day = days[static_cast<std::size_t>(scan.stamp.ns / kDay_ns)];
    return day.truth[static_cast<std::size_t>(scan.stamp.ns % kDay_ns / 100'000'000)];
  };
  double sum_m2 = 0.0;
  for (const MappedScan& scan : map.scans) {
    const Pose2 truth = true_pose(map.scans.front()).inverse() * true_pose(scan);
    const Pose2 pose = map.scans.front().T_map_base.inverse() * scan.T_map_base;
    sum_m2 += (pose.translation() - truth.translation()).squaredNorm();
  }
  return std::sqrt(sum_m2 / static_cast<double>(map.scans.size()));
}

/// What a map tells of its sessions is true of the days that it was made of.
void expect_truthful(const Map& map, std::span<const Day> days) {
  validate(map);
  std::size_t num_driven = 0;
  for (const Day& day : days) num_driven += day.scans.size();
  const MapSummary summary = summary_of(map);
  EXPECT_EQ(map.scans.size() + summary.num_forgotten_poses, num_driven);
  std::size_t next_scan = 0;
  for (const MapSession& session : map.sessions) {
    EXPECT_EQ(session.first_scan, next_scan);
    EXPECT_TRUE(is_joined(map, session));
    next_scan += session.num_scans;
    const auto day = map.scans[session.first_scan].stamp.ns / kDay_ns;
    for (std::size_t i = session.first_scan; i < next_scan; ++i) {
      ASSERT_EQ(map.scans[i].stamp.ns / kDay_ns, day);
    }
  }
  EXPECT_EQ(next_scan, map.scans.size());
  EXPECT_EQ(map.sessions.back().num_scans, days.back().scans.size()) << "the newest is whole";
}

TEST(KnownSessions, APatrolDayAfterDayKeepsNoMoreThanItsFirstDaysLeft) {
  const std::vector<Day> days = days_at_random(9);
  const std::vector<Map> maps = maps_of(days, params_of(true));
  for (std::size_t d = 0; d < maps.size(); ++d)
    expect_truthful(maps[d], std::span(days).first(d + 1));
  const std::size_t of_a_day = maps[0].keyframes.size();
  const Map& of_6 = maps[5];
  const Map& of_9 = maps[8];
  EXPECT_GT(of_9.num_forgotten, of_6.num_forgotten + 2 * of_a_day);
  EXPECT_LT(of_9.keyframes.size(), of_6.keyframes.size() + of_a_day / 2);
  EXPECT_LT(of_9.kept_scans.size(), of_6.kept_scans.size() + maps[0].kept_scans.size() / 2);
  EXPECT_LT(of_9.scans.size(), of_6.scans.size() + 2 * days[0].scans.size());
  EXPECT_LT(of_9.closures.size(), of_6.closures.size() * 5 / 4);
}

TEST(KnownSessions, TheMapIsNoWorseAndSwitchedOffItGrows) {
  const std::vector<Day> days = days_at_random(7);
  const Map forgotten = maps_of(days, params_of(true)).back();
  const std::vector<Map> kept = maps_of(days, params_of(false));
  ASSERT_GT(forgotten.num_forgotten, 0U);
  EXPECT_EQ(kept.back().num_forgotten, 0U);
  EXPECT_GT(kept.back().keyframes.size(), 2 * kept[2].keyframes.size());
  EXPECT_LT(forgotten.keyframes.size(), kept.back().keyframes.size() * 4 / 5);
  EXPECT_LT(error_m(forgotten, days), error_m(kept.back(), days) + 0.005);
  // The frame stays.
  const MappedScan& first = kept.front().scans.front();
  EXPECT_THAT(forgotten.scans.front().T_map_base, PoseNear(first.T_map_base, kSame));
}

TEST(KnownSessions, SameInputSameBitsOnAnyNumberOfThreads) {
  const std::vector<Day> days = days_at_random(6);
  const Map one = maps_of(days, params_of(true, 1)).back();
  const Map three = maps_of(days, params_of(true, 3)).back();
  ASSERT_GT(one.num_forgotten, 0U);
  EXPECT_EQ(one.keyframes, three.keyframes);
  ASSERT_EQ(one.scans.size(), three.scans.size());
  for (std::size_t i = 0; i < one.scans.size(); ++i) {
    ASSERT_EQ(one.scans[i].T_map_base, three.scans[i].T_map_base) << i;
  }
}

TEST(KnownSessions, KeepWhatShowsThatWallsChanged) {
  std::vector<Wall> later = testing::corridor_around_a_block();
  later.push_back({8.0, 12.0, 8.0, 11.3});  // A cabinet.
  later.push_back({8.0, 11.3, 6.5, 11.3});
  later.push_back({6.5, 11.3, 6.5, 12.0});
  std::vector<Day> days = days_at_random(5);
  for (std::size_t d = 5; d < 8; ++d) days.push_back(day_of(d, d % 4, 5, later));
  const Map map = maps_of(days, params_of(true)).back();
  ASSERT_GT(map.num_forgotten, 0U);
  const Pose2 T_map_world = map.scans.front().T_map_base * days[0].truth[0].inverse();
  // By the rule of one run: what saw the change first stays, later visits agree with it.
  EXPECT_TRUE(std::ranges::any_of(map.keyframes, [&](std::size_t scan) {
    const Eigen::Vector2d place = T_map_world.inverse() * map.scans[scan].T_map_base.translation();
    return map.scans[scan].stamp.ns / kDay_ns == 5 && std::abs(place.x() - 7.25) < 2.0 &&
           place.y() > 10.0;
  }));
  const OccupancyGrid grid = occupancy_grid(map);
  const auto is_wall_about = [&](const Eigen::Vector2d& p_world) {
    const Eigen::Vector2d p = grid.T_map_grid().inverse() * (T_map_world * p_world);
    const auto column = static_cast<std::int32_t>(p.x() / grid.resolution_m());
    const auto row = static_cast<std::int32_t>(p.y() / grid.resolution_m());
    for (std::int32_t c = column - 1; c <= column + 1; ++c) {
      for (std::int32_t r = row - 1; r <= row + 1; ++r) {
        if (grid.state({c, r}) == CellState::kOccupied) return true;
      }
    }
    return false;
  };
  EXPECT_TRUE(is_wall_about({7.25, 11.3}));
  EXPECT_FALSE(is_wall_about({3.0, 11.3}));
}

TEST(KnownSessions, ASessionThatIsGoneOnWithForgetsByItsOwnVisits) {
  const Day first = day_of(0, 0, 5);
  const Day long_day = day_of(1, 2, 30);
  const Map map = gone_on(gone_on(std::nullopt, first, params_of(true)), long_day, params_of(true));
  EXPECT_GT(map.num_forgotten, 100U);
  ASSERT_EQ(map.sessions.size(), 2U);
  EXPECT_TRUE(is_joined(map, map.sessions.back()));
  EXPECT_EQ(map.scans.size(), first.scans.size() + long_day.scans.size());
  EXPECT_LT(error_m(map, std::array{first, long_day}), 0.03);
}

TEST(KnownSessions, WhatIsNotJoinedForgetsNothing) {
  std::vector<Day> days = days_at_random(5);
  Day elsewhere = day_of(5, 0, 0);
  elsewhere.truth = testing::drive(testing::way_around_the_room());
  elsewhere.scans.clear();
  for (std::size_t i = 0; i < elsewhere.truth.size(); ++i) {
    elsewhere.scans.push_back(testing::scan_of_walls(
        testing::l_shaped_room(), elsewhere.truth[i], testing::kAllAround, kNoise_m, 900'000 + i));
    elsewhere.scans.back().stamp.ns = 5 * kDay_ns + static_cast<std::int64_t>(i) * 100'000'000;
  }
  days.push_back(elsewhere);
  days.push_back(day_of(6, 3, 5));
  const Map map = maps_of(days, params_of(true)).back();
  ASSERT_GT(map.num_forgotten, 0U);
  const auto apart = std::ranges::find_if(map.sessions, [&](const MapSession& session) {
    return map.scans[session.first_scan].stamp.ns / kDay_ns == 5;
  });
  ASSERT_NE(apart, map.sessions.end());
  EXPECT_FALSE(is_joined(map, *apart));
  EXPECT_EQ(apart->num_scans, elsewhere.scans.size());
  const Map alone = gone_on(std::nullopt, elsewhere, params_of(true));
  EXPECT_EQ(
      std::ranges::count_if(
          map.keyframes, [&](std::size_t scan) { return map.scans[scan].stamp.ns / kDay_ns == 5; }),
      static_cast<std::ptrdiff_t>(alone.keyframes.size()));
  EXPECT_TRUE(is_joined(map, map.sessions.back()));
}

TEST(KnownSessions, MergedWithAnEarlierMapEachLogCountsOnce) {
  const std::vector<Day> days = days_at_random(6);
  const std::vector<Map> maps = maps_of(days, params_of(true));
  ASSERT_GT(maps[5].num_forgotten, 0U);
  for (const auto& pair : {std::array{maps[5], maps[2]}, std::array{maps[2], maps[5]}}) {
    const Map merged = merge(pair, params_of(true));
    std::set<std::int64_t> days_told;
    for (const MapSession& session : merged.sessions) {
      EXPECT_TRUE(days_told.insert(merged.scans[session.first_scan].stamp.ns / kDay_ns).second);
    }
  }
}

TEST(KnownSessions, PosesOfEarlierSessionsAreBounded) {
  const std::vector<Day> days = days_at_random(6);
  MapperParams params = params_of(true);
  params.forgetting.max_poses_before = 0;
  const Map all = maps_of(days, params_of(true)).back();
  const Map few = maps_of(days, params).back();
  expect_truthful(few, days);
  EXPECT_LT(few.scans.size(), all.scans.size());
  EXPECT_LT(error_m(few, days), error_m(all, days) + 0.005);
}

TEST(KnownSessions, OfOneSessionNothingIsForgotten) {
  const Map map = gone_on(std::nullopt, day_of(0, 0, 20), params_of(false));
  const Map again = without_known_places(map, params_of(true));
  EXPECT_EQ(again.keyframes, map.keyframes);
  EXPECT_EQ(again.scans.size(), map.scans.size());
  EXPECT_EQ(again.track.T_odom_sensor, map.track.T_odom_sensor);
}

}  // namespace setsquare::known_sessions_test
