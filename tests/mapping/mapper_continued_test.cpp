// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Maps that are gone on with, and maps that are merged.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/mapping/growing_map.hpp"
#include "setsquare/mapping/log_tracker.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "tests/mapping/tracked_world.hpp"
#include "tests/support/pose_matchers.hpp"

namespace setsquare::mapper_continued_test {

using testing::between;
using testing::drive;
using testing::PoseNear;
using testing::PoseTolerance;
using testing::scans_on_drive;
using testing::Wall;

constexpr double kNoise_m = 0.01;
const PoseTolerance kRounding{.translation_m = 1e-9, .rotation_rad = 1e-9};
const PoseTolerance kTrue{.translation_m = 0.08, .rotation_rad = rad_from_deg(0.7)};
/// Of a map beside which another piece lies that is not joined to it: the walls of both tell how
/// far headings are to be believed.
const PoseTolerance kUndisturbed{.translation_m = 1e-3, .rotation_rad = rad_from_deg(0.02)};
/// Between two maps of the same scans.
const PoseTolerance kSame{.translation_m = 0.03, .rotation_rad = rad_from_deg(0.3)};

/// A drive with the scans on it.
struct Log {
  std::vector<Pose2> truth;
  std::vector<Scan> scans;
};

/// The drives of a test have different noise, and stamps one after the other.
Log log_of(const std::vector<Wall>& walls,
           const std::vector<Eigen::Vector2d>& way,
           std::int64_t first_s) {
  Log log{.truth = drive(way), .scans = {}};
  for (std::size_t i = 0; i < log.truth.size(); ++i) {
    const std::size_t seed = 100'000 * static_cast<std::size_t>(first_s + 1) + i;
    log.scans.push_back(
        testing::scan_of_walls(walls, log.truth[i], testing::kAllAround, kNoise_m, seed));
    log.scans.back().stamp.ns =
        1'000'000'000 * first_s + 100'000'000 * static_cast<std::int64_t>(i);
  }
  return log;
}

Map mapped(Mapper mapper, const Log& log) {
  for (const Scan& scan : log.scans) mapper.add(scan);
  return mapper.finish();
}

Map map_of(const Log& log) { return mapped(Mapper(), log); }
Map continued(const Map& map, const Log& log) { return mapped(Mapper(map), log); }

/// A corridor 2 m wide around a block of 12 m x 8 m, with bays of different width and depth, so
/// that no corner looks like another one.
std::vector<Wall> floor_with_bays() {
  const std::vector<Eigen::Vector2d> outer{
      {0.0, 0.0},   {4.0, 0.0},   {4.0, -2.0},  {7.0, -2.0},  {7.0, 0.0},   {11.5, 0.0},
      {11.5, -0.8}, {12.7, -0.8}, {12.7, 0.0},  {16.0, 0.0},  {16.0, 4.0},  {19.0, 4.0},
      {19.0, 6.5},  {16.0, 6.5},  {16.0, 12.0}, {13.0, 12.0}, {13.0, 13.2}, {11.2, 13.2},
      {11.2, 12.0}, {5.5, 12.0},  {5.5, 15.0},  {3.0, 15.0},  {3.0, 12.0},  {0.0, 12.0},
      {0.0, 9.0},   {-1.5, 9.0},  {-1.5, 7.8},  {0.0, 7.8},   {0.0, 4.0},   {-2.5, 4.0},
      {-2.5, 2.5},  {0.0, 2.5}};
  std::vector<Wall> walls{{2.0, 2.0, 14.0, 2.0},
                          {14.0, 2.0, 14.0, 10.0},
                          {14.0, 10.0, 2.0, 10.0},
                          {2.0, 10.0, 2.0, 2.0}};
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const Eigen::Vector2d& next = outer[(i + 1) % outer.size()];
    walls.push_back({outer[i].x(), outer[i].y(), next.x(), next.y()});
  }
  return walls;
}

/// Three ways around the block, each of which has a side in common with the next.
std::array<Log, 3> three_parts() {
  const std::vector<Wall> walls = floor_with_bays();
  return {log_of(walls, {{1.0, 1.0}, {15.0, 1.0}, {15.0, 6.0}}, 1000),
          log_of(walls, {{8.0, 1.0}, {15.0, 1.0}, {15.0, 11.0}, {8.0, 11.0}}, 2000),
          log_of(walls, {{15.0, 8.0}, {15.0, 11.0}, {1.0, 11.0}, {1.0, 1.0}, {6.0, 1.0}}, 3000)};
}

/// The truth of all scans of a map, session by session, by their stamps.
std::vector<Pose2> truth_of(const Map& map, std::span<const Log> logs) {
  std::vector<Pose2> truth;
  for (const MappedScan& scan : map.scans) {
    for (const Log& log : logs) {
      const auto at = std::ranges::find(log.scans, scan.stamp, &Scan::stamp);
      if (at != log.scans.end()) truth.push_back(log.truth[at - log.scans.begin()]);
    }
  }
  return truth;
}

void expect_true_poses(const Map& map, std::span<const Log> logs) {
  const std::vector<Pose2> truth = truth_of(map, logs);
  ASSERT_EQ(truth.size(), map.scans.size());
  for (std::size_t i = 0; i < truth.size(); i += 5) {
    ASSERT_TRUE(map.scans[i].is_placed) << i;
    ASSERT_THAT(between(map.scans[0].T_map_sensor, map.scans[i].T_map_sensor),
                PoseNear(between(truth[0], truth[i]), kTrue))
        << i;
  }
}

/// The scans of `map` lie in `other` where they lie in itself.
void expect_where_they_lay(const Map& map, const Map& other, const PoseTolerance& tolerance) {
  for (const MappedScan& scan : map.scans) {
    const auto at = std::ranges::find(other.scans, scan.stamp, &MappedScan::stamp);
    ASSERT_NE(at, other.scans.end());
    ASSERT_THAT(at->T_map_base, PoseNear(scan.T_map_base, tolerance));
  }
}

void expect_same(const Map& a, const Map& b, const PoseTolerance& tolerance) {
  ASSERT_EQ(a.scans.size(), b.scans.size());
  for (std::size_t i = 0; i < a.scans.size(); ++i) {
    ASSERT_EQ(a.scans[i].stamp, b.scans[i].stamp);
    ASSERT_EQ(a.scans[i].is_placed, b.scans[i].is_placed);
    ASSERT_THAT(b.scans[i].T_map_base, PoseNear(a.scans[i].T_map_base, tolerance)) << i;
    ASSERT_THAT(b.scans[i].T_map_sensor, PoseNear(a.scans[i].T_map_sensor, tolerance)) << i;
  }
  EXPECT_EQ(a.keyframes, b.keyframes);
  ASSERT_EQ(a.closures.size(), b.closures.size());
  for (std::size_t i = 0; i < a.closures.size(); ++i) {
    EXPECT_NEAR(a.closures[i].closure.weight, b.closures[i].closure.weight, 1e-9);
  }
  ASSERT_EQ(a.pieces.size(), b.pieces.size());
  for (std::size_t i = 0; i < a.pieces.size(); ++i) {
    EXPECT_EQ(a.pieces[i].first_scan, b.pieces[i].first_scan);
    EXPECT_EQ(a.pieces[i].is_joined, b.pieces[i].is_joined);
  }
  ASSERT_EQ(a.kept_scans.size(), b.kept_scans.size());
  for (std::size_t i = 0; i < a.kept_scans.size(); ++i) {
    EXPECT_EQ(a.kept_scans[i].index, b.kept_scans[i].index);
    EXPECT_EQ(a.kept_scans[i].scan->ranges_m, b.kept_scans[i].scan->ranges_m);
  }
}

TEST(MapperContinued, WithNothingIsTheSameMap) {
  const Log log = three_parts()[2];
  Mapper mapper;
  for (Scan scan : log.scans) {
    scan.T_base_sensor = {0.2, -0.05, 0.1};
    mapper.add(scan);
  }
  const Map map = mapper.finish();
  expect_same(map, Mapper(map).finish(), kRounding);
}

TEST(MapperContinued, WithNothingPiecesStayAsTheyAre) {
  // Carried from one building to another and back.
  const Log room = log_of(testing::l_shaped_room(), testing::way_around_the_room(), 0);
  const Log block = log_of(floor_with_bays(), {{1.0, 4.0}, {1.0, 1.0}}, 100);
  const Log back = log_of(testing::l_shaped_room(), {{2.0, 7.5}, {1.5, 5.0}, {5.5, 2.5}}, 200);
  Mapper mapper;
  for (const Log* log : {&room, &block, &back}) {
    for (const Scan& scan : log->scans) mapper.add(scan);
  }
  const Map map = mapper.finish();
  ASSERT_EQ(map.pieces.size(), 3U);
  expect_same(map, Mapper(map).finish(), kRounding);
}

TEST(MapperContinued, PartsInAnyOrderThatOverlapAreTheWhole) {
  const std::array<Log, 3> parts = three_parts();
  for (const auto& order : {std::array{0, 1, 2}, {2, 1, 0}, {1, 2, 0}, {2, 0, 1}}) {
    Map map = map_of(parts[order[0]]);
    map = continued(map, parts[order[1]]);
    map = continued(map, parts[order[2]]);
    ASSERT_EQ(map.sessions.size(), 3U);
    expect_true_poses(map, parts);
    // Continuing with nothing changes nothing of this one, either.
    expect_same(map, Mapper(map).finish(), kSame);
  }
}

TEST(MapperContinued, MapsOnTheWayLieAsTheFinishedOneDoes) {
  const std::array<Log, 3> parts = three_parts();
  const Map known = map_of(parts[0]);
  GrowingMap growing{MapperParams{}};
  growing.add(known);
  LogTracker tracker{MapperParams{}};
  std::size_t num_placed = 0;
  for (std::size_t i = 0; i < parts[1].scans.size(); ++i) {
    TrackSteps steps;
    (void)tracker.add(parts[1].scans[i], std::nullopt, steps);
    growing.add(std::move(steps));
    if (i % 40 != 39) continue;
    const Map next = growing.make_next({});
    const Map whole = growing.make({});
    ASSERT_EQ(next.scans.size(), whole.scans.size());
    num_placed += next.scans.back().is_placed;
    for (std::size_t k = 0; k < next.scans.size(); ++k) {
      ASSERT_EQ(next.scans[k].is_placed, whole.scans[k].is_placed) << i << ", " << k;
      if (!next.scans[k].is_placed) continue;
      ASSERT_THAT(next.scans[k].T_map_base, PoseNear(whole.scans[k].T_map_base, kSame))
          << i << ", " << k;
    }
  }
  EXPECT_GE(num_placed, 3U);
  const Map finished = growing.make({});
  const Map again = continued(known, parts[1]);
  ASSERT_EQ(finished.scans.size(), again.scans.size());
  for (std::size_t k = 0; k < finished.scans.size(); ++k) {
    ASSERT_EQ(finished.scans[k].T_map_base, again.scans[k].T_map_base) << k;
  }
}

TEST(MapperContinued, TheFrameStays) {
  // What was mapped first is a small part of it.
  const std::array<Log, 3> parts = three_parts();
  const Map first = map_of(log_of(floor_with_bays(), {{5.0, 1.0}, {10.0, 1.0}}, 1));
  const Map map = continued(continued(first, parts[0]), parts[1]);
  for (const MapSession& session : map.sessions) EXPECT_TRUE(is_joined(map, session));
  expect_where_they_lay(first, map, kSame);
}

TEST(MapperContinued, WhatIsElsewhereStaysApartUntilItIsFound) {
  const std::vector<Wall> walls = floor_with_bays();
  const Log low = log_of(walls, {{1.0, 3.0}, {1.0, 1.0}, {8.0, 1.0}}, 1000);
  const Log high = log_of(walls, {{15.0, 9.0}, {15.0, 11.0}, {8.0, 11.0}}, 2000);
  const Log between_them =
      log_of(walls, {{4.0, 1.0}, {15.0, 1.0}, {15.0, 11.0}, {9.0, 11.0}}, 3000);
  const Map of_low = map_of(low);
  const Map apart = continued(of_low, high);
  ASSERT_EQ(apart.sessions.size(), 2U);
  EXPECT_TRUE(is_joined(apart, apart.sessions[0]));
  EXPECT_FALSE(is_joined(apart, apart.sessions[1]));
  EXPECT_GT(apart.sessions[1].search.num_pairs, 0U);
  EXPECT_FALSE(apart.scans.back().is_placed);
  expect_where_they_lay(of_low, apart, kUndisturbed);
  const Map map = continued(apart, between_them);
  for (const MapSession& session : map.sessions) EXPECT_TRUE(is_joined(map, session));
  expect_true_poses(map, std::array{low, high, between_them});
  expect_where_they_lay(of_low, map, kSame);
}

std::vector<Wall> mirrored(std::vector<Wall> walls) {
  for (Wall& wall : walls) wall = {wall.x1_m, -wall.y1_m, wall.x2_m, -wall.y2_m};
  return walls;
}

TEST(MergedMaps, OneThatSharesNothingStaysApart) {
  const Map room = map_of(log_of(testing::l_shaped_room(), testing::way_around_the_room(), 0));
  const Map block = map_of(three_parts()[2]);
  const Map image = map_of(log_of(mirrored(testing::l_shaped_room()),
                                  {{2.0, -7.5}, {1.5, -5.0}, {2.5, -2.0}, {5.5, -2.5}, {3.0, -1.0}},
                                  500));
  for (const auto& [a, b] : {std::pair{&room, &block}, {&block, &room}, {&room, &image}}) {
    const Map map = merge(std::array{*a, *b});
    ASSERT_EQ(map.sessions.size(), 2U);
    EXPECT_TRUE(is_joined(map, map.sessions[0]));
    EXPECT_FALSE(is_joined(map, map.sessions[1]));
    const SessionSearch& search = map.sessions[1].search;
    EXPECT_GT(search.num_pairs, 0U);
    EXPECT_LE(search.num_agreeing, search.num_matched);
    expect_where_they_lay(*a, map, kUndisturbed);
  }
}

TEST(MergedMaps, AreTheSameWhicheverComesFirstUpToTheFrame) {
  const std::array<Log, 3> parts = three_parts();
  const std::array maps{map_of(parts[0]), map_of(parts[1]), map_of(parts[2])};
  const Map there = merge(maps);
  const Map back = merge(std::array{maps[2], maps[1], maps[0]});
  expect_true_poses(there, parts);
  expect_true_poses(back, parts);
  expect_where_they_lay(maps[0], there, kSame);
  expect_where_they_lay(maps[2], back, kSame);
  // The stamps tell which is newer, not the order.
  for (const Map* map : {&there, &back}) {
    for (const MapSession& session : map->sessions) {
      EXPECT_EQ(session.recency, map->scans[session.first_scan].stamp.ns / 1'000'000'000'000 - 1);
    }
  }
}

TEST(MergedMaps, WithItselfAMapStaysAsItIs) {
  const Map map = map_of(three_parts()[1]);
  expect_same(map, merge(std::array{map, map, map}), kRounding);
  expect_same(map, merge({&map, 1}), kRounding);
}

TEST(MergedMaps, WhatTheyShareCountsOnce) {
  const std::array<Log, 3> parts = three_parts();
  const Map common = map_of(parts[1]);
  const Map map = merge(std::array{continued(common, parts[0]), continued(common, parts[2])});
  ASSERT_EQ(map.sessions.size(), 3U);
  EXPECT_EQ(map.scans.size(),
            parts[0].scans.size() + parts[1].scans.size() + parts[2].scans.size());
  expect_true_poses(map, parts);
}

TEST(MergedMaps, NoMapIsNone) {
  EXPECT_THROW((void)merge({}), ParameterError);
  EXPECT_THROW((void)Mapper(Map{}), ParameterError);
  Map without_track = map_of(three_parts()[0]);
  without_track.track = {};
  EXPECT_THROW((void)Mapper(without_track), ParameterError);
  EXPECT_THROW((void)merge({&without_track, 1}), ParameterError);
  Map without_scans = map_of(three_parts()[0]);
  without_scans.kept_scans.clear();
  EXPECT_THROW((void)Mapper(without_scans), ParameterError);
}

TEST(MapperContinued, StampsMayLieInAnyOrder) {
  const std::array<Log, 3> parts = three_parts();
  const Map map = continued(map_of(parts[0]), parts[1]);
  for (const std::int64_t shift_s : {-5000, -1000, -998}) {
    Log earlier = parts[1];
    for (Scan& scan : earlier.scans) scan.stamp.ns += 1'000'000'000 * shift_s;
    const Map other = continued(map_of(parts[0]), earlier);
    ASSERT_EQ(other.scans.size(), map.scans.size());
    for (std::size_t i = 0; i < map.scans.size(); ++i) {
      ASSERT_EQ(other.scans[i].T_map_base, map.scans[i].T_map_base);
    }
    EXPECT_EQ(other.sessions[1].recency, 1U) << "what comes later is newer";
  }
}

TEST(MapperContinued, SameInputSameBitsOnAnyNumberOfThreads) {
  const std::array<Log, 3> parts = three_parts();
  const Map first = map_of(parts[0]);
  const Map one = continued(first, parts[1]);
  MapperParams with_three;
  with_three.num_threads = 3;
  const Map three = mapped(Mapper(first, with_three), parts[1]);
  ASSERT_EQ(one.scans.size(), three.scans.size());
  for (std::size_t i = 0; i < one.scans.size(); ++i) {
    ASSERT_EQ(one.scans[i].T_map_base, three.scans[i].T_map_base);
  }
  EXPECT_EQ(one.graph.T_map_node, three.graph.T_map_node);
}

TEST(MapperContinued, ALogOfWhichNothingIsSeenAddsNothing) {
  const Map map = map_of(three_parts()[0]);
  Log dark = three_parts()[1];
  dark.scans.erase(dark.scans.begin() + 20, dark.scans.end());
  for (Scan& scan : dark.scans) {
    std::ranges::fill(scan.ranges_m, std::numeric_limits<double>::infinity());
  }
  expect_same(map, continued(map, dark), kRounding);
  // Nor does it where another one follows it.
  Mapper mapper(continued(map, dark));
  const Log bright = three_parts()[1];
  for (const Scan& scan : bright.scans) mapper.add(scan);
  EXPECT_EQ(mapper.finish().sessions.size(), 2U);
}

TEST(MapperContinued, ScansBeforeTheFirstKeyframeHangOnIt) {
  const std::array<Log, 3> parts = three_parts();
  Log begins_dark = parts[1];
  for (std::size_t i = 0; i < 3; ++i) {
    std::ranges::fill(begins_dark.scans[i].ranges_m, std::numeric_limits<double>::infinity());
  }
  const Map map = continued(map_of(parts[0]), begins_dark);
  const std::size_t first = map.sessions.at(1).first_scan;
  EXPECT_EQ(map.pieces.at(1).first_scan, first);
  EXPECT_THAT(between(map.scans[first].T_map_sensor, map.scans[first + 3].T_map_sensor),
              PoseNear(Pose2{}, PoseTolerance{.translation_m = 0.5, .rotation_rad = 0.5}));
}

/// The room with a cupboard in it, or without.
std::vector<Wall> room_with_cupboard(const Eigen::Vector2d& corner_m) {
  std::vector<Wall> walls = testing::l_shaped_room();
  const double x = corner_m.x();
  const double y = corner_m.y();
  const double w = 0.6;
  for (const Wall& wall : {Wall{x, y, x + w, y},
                           Wall{x + w, y, x + w, y + w},
                           Wall{x + w, y + w, x, y + w},
                           Wall{x, y + w, x, y}}) {
    walls.push_back(wall);
  }
  return walls;
}

TEST(MapperContinued, WhatWasMovedStandsWhereTheNewestSawIt) {
  const Eigen::Vector2d before(3.0, 1.9);
  const Eigen::Vector2d after(6.5, 3.3);
  const std::vector<Eigen::Vector2d> way{
      {1.0, 1.0}, {5.0, 1.2}, {5.5, 2.8}, {2.0, 4.0}, {2.0, 8.0}, {2.0, 3.0}, {1.0, 1.0}};
  const Log old = log_of(room_with_cupboard(before), way, 1000);
  const Log recent = log_of(room_with_cupboard(after), way, 2000);
  const auto state_at = [&](const Map& map, const OccupancyGrid& grid, Eigen::Vector2d place_m) {
    // The way begins at (1, 1) along x, and the map at its first keyframe.
    const Eigen::Vector2d p =
        grid.T_map_grid().inverse() *
        (map.scans[0].T_map_sensor * Pose2{1.0, 1.0, 0.0}.inverse() * place_m);
    return grid.state({static_cast<std::int32_t>(p.x() / grid.resolution_m()),
                       static_cast<std::int32_t>(p.y() / grid.resolution_m())});
  };
  /// Cells of the nearer side of a cupboard that are occupied, of the ten in its middle.
  const auto num_occupied = [&](const Map& map, const Eigen::Vector2d& corner_m) {
    const OccupancyGrid grid = occupancy_grid(map);
    int num = 0;
    for (int i = 0; i < 10; ++i) {
      bool is_occupied = false;
      for (const double off_m : {-0.05, 0.0, 0.05}) {
        const Eigen::Vector2d place = corner_m + Eigen::Vector2d(0.05 + 0.05 * i, off_m);
        is_occupied = is_occupied || state_at(map, grid, place) == CellState::kOccupied;
      }
      num += is_occupied ? 1 : 0;
    }
    return num;
  };
  const Map of_old = map_of(old);
  EXPECT_GE(num_occupied(of_old, before), 9);
  EXPECT_TRUE(occupancy_grid_with_changes(of_old).changes.empty());
  const Map map = continued(of_old, recent);
  ASSERT_TRUE(is_joined(map, map.sessions[1]));
  EXPECT_EQ(num_occupied(map, before), 0);
  EXPECT_GE(num_occupied(map, after), 9);
  const std::vector<ChangedPlace> changes = occupancy_grid_with_changes(map).changes;
  const auto is_told = [&](bool is_gone, const Eigen::Vector2d& corner_m) {
    return std::ranges::any_of(changes, [&](const ChangedPlace& place) {
      const Eigen::Vector2d in_world =
          Pose2{1.0, 1.0, 0.0} * map.scans[0].T_map_sensor.inverse() * place.place_m;
      return place.is_gone == is_gone &&
             (in_world - corner_m - Eigen::Vector2d(0.3, 0.3)).norm() < 0.6;
    });
  };
  EXPECT_TRUE(is_told(true, before));
  EXPECT_TRUE(is_told(false, after));
  EXPECT_LE(changes.size(), 4U);
  // Merged in the other order the stamps still tell which is newer.
  const Map merged = merge(std::array{map_of(recent), of_old});
  EXPECT_EQ(num_occupied(merged, before), 0);
  EXPECT_GE(num_occupied(merged, after), 9);
}

/// The rule switched off: all scans are of one session.
TEST(MapperContinued, WithoutRecencyWhatWasSeenMostStands) {
  const std::vector<Eigen::Vector2d> way{
      {1.0, 1.0}, {5.0, 1.2}, {5.5, 2.8}, {2.0, 4.0}, {2.0, 8.0}, {2.0, 3.0}, {1.0, 1.0}};
  const Map first = map_of(log_of(room_with_cupboard({3.0, 1.9}), way, 1000));
  Map map = continued(first, log_of(testing::l_shaped_room(), way, 2000));
  EXPECT_FALSE(occupancy_grid_with_changes(map).changes.empty());
  const std::vector<float> newest = occupancy_grid(map).values();
  for (MapSession& session : map.sessions) session.recency = 0;
  EXPECT_TRUE(occupancy_grid_with_changes(map).changes.empty());
  EXPECT_NE(occupancy_grid(map).values(), newest);
}

}  // namespace setsquare::mapper_continued_test
