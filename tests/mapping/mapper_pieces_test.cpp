// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Logs with holes: the robot was moved while nothing was recorded.
#include <gtest/gtest.h>

#include <algorithm>

#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "tests/mapping/tracked_world.hpp"
#include "tests/support/pose_matchers.hpp"

namespace setsquare::mapper_pieces_test {

using testing::between;
using testing::drive;
using testing::PoseNear;
using testing::PoseTolerance;
using testing::scans_on_drive;
using testing::Wall;

constexpr double kNoise_m = 0.01;

/// Drives in different places, without the ways between them.
struct LogWithHoles {
  void add(const std::vector<Wall>& walls, const std::vector<Pose2>& T_world_sensor) {
    begins.push_back(scans.size());
    for (Scan& scan : scans_on_drive(walls, T_world_sensor, kNoise_m, testing::kAllAround)) {
      scan.stamp.ns = 100'000'000 * static_cast<std::int64_t>(scans.size());
      scans.push_back(std::move(scan));
    }
    truth.insert(truth.end(), T_world_sensor.begin(), T_world_sensor.end());
  }
  std::vector<Pose2> truth;
  std::vector<Scan> scans;
  std::vector<std::size_t> begins;  ///< First scans of the drives.
};

Map map_of(const LogWithHoles& log, const MapperParams& params, bool has_odometry = false) {
  Mapper mapper(params);
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    mapper.add(log.scans[i], has_odometry ? std::optional(log.truth[i]) : std::nullopt);
  }
  return mapper.finish();
}

/// Carried from a room to another building and back into the room.
LogWithHoles carried_away_and_back() {
  LogWithHoles log;
  log.add(testing::l_shaped_room(), drive(testing::way_around_the_room()));
  log.add(testing::corridor_around_a_block(), drive({{1.0, 4.0}, {1.0, 1.0}, {7.0, 1.0}}));
  log.add(testing::l_shaped_room(), drive({{2.0, 7.5}, {1.5, 5.0}, {2.5, 2.0}, {5.5, 2.5}}));
  return log;
}

/// Carried to another building.
LogWithHoles carried_elsewhere() {
  LogWithHoles log;
  log.add(testing::corridor_around_a_block(),
          drive({{1.0, 6.0}, {1.0, 1.0}, {15.0, 1.0}, {15.0, 11.0}}));
  log.add(testing::l_shaped_room(),
          drive({{1.5, 1.5}, {5.0, 1.5}, {5.5, 3.5}, {2.0, 4.0}, {2.0, 7.5}}));
  return log;
}

/// Every fifth of some scans lies where it lies in truth, seen from another scan.
void expect_true_poses(const Map& track,
                       const LogWithHoles& log,
                       std::size_t from,
                       std::size_t begin,
                       std::size_t end) {
  for (std::size_t i = begin; i < end; i += 5) {
    ASSERT_THAT(between(track.scans[from].T_map_sensor, track.scans[i].T_map_sensor),
                PoseNear(between(log.truth[from], log.truth[i]),
                         PoseTolerance{.translation_m = 0.08, .rotation_rad = rad_from_deg(0.7)}))
        << i;
  }
}

/// Key frames in a room, one of which somebody has covered; after it the track is too short to be
/// found anywhere by itself.
LogWithHoles key_frames_one_covered() {
  LogWithHoles log;
  const auto frames = testing::spaced(drive(testing::way_around_the_room()), 0.7, 0.5);
  const auto end = frames.begin() + 18;
  log.add(testing::l_shaped_room(), {frames.begin(), end});
  const double closet_m = 0.4;
  log.add({{-closet_m, -closet_m, closet_m, -closet_m},
           {closet_m, -closet_m, closet_m, closet_m},
           {closet_m, closet_m, -closet_m, closet_m},
           {-closet_m, closet_m, -closet_m, -closet_m}},
          {Pose2{}});
  log.add(testing::l_shaped_room(), {end, end + 5});
  return log;
}

TEST(MapperPieces, AreJoinedAcrossAScanThatSawNothing) {
  const LogWithHoles log = key_frames_one_covered();
  const Map map = map_of(log, {});
  const std::size_t after = log.begins[2];
  EXPECT_FALSE(map.scans[log.begins[1]].is_placed);
  ASSERT_TRUE(map.scans[0].is_placed && map.scans[after].is_placed);
  expect_true_poses(map, log, 0, after, log.scans.size());
}

/// The rule switched off: more votes asked for than there can be.
TEST(MapperPieces, FallApartWhereNothingIsMatchedAcrossTheBreak) {
  const LogWithHoles log = key_frames_one_covered();
  MapperParams params;
  params.joining.min_agreeing = 100;  // Nor by places elsewhere.
  EXPECT_TRUE(map_of(log, params).scans[log.begins[2]].is_placed) << "with the rule";
  params.joining.min_votes_across_break = 100.0;
  params.joining.min_log_odds_across_break = 100.0;
  EXPECT_FALSE(map_of(log, params).scans[log.begins[2]].is_placed);
}

TEST(MapperPieces, AreJoinedWhereTheirWaysOverlap) {
  const LogWithHoles log = carried_away_and_back();
  const Map track = map_of(log, {});
  ASSERT_EQ(track.pieces.size(), 3U);
  EXPECT_TRUE(track.pieces[0].is_joined);
  EXPECT_FALSE(track.pieces[1].is_joined);
  EXPECT_TRUE(track.pieces[2].is_joined);
  expect_true_poses(track, log, 0, 0, log.begins[1]);
  expect_true_poses(track, log, 0, track.pieces[2].first_scan, log.scans.size());
}

TEST(MapperPieces, WithoutOverlapAPieceIsReportedAsNotJoined) {
  const LogWithHoles log = carried_elsewhere();
  const Map track = map_of(log, {});
  ASSERT_EQ(track.pieces.size(), 2U);
  EXPECT_TRUE(track.pieces[0].is_joined);
  EXPECT_FALSE(track.pieces[1].is_joined);
  EXPECT_EQ(track.pieces[0].first_scan, 0U);
  EXPECT_EQ(track.pieces[0].num_scans, track.pieces[1].first_scan);
  EXPECT_EQ(track.pieces[1].first_scan + track.pieces[1].num_scans, log.scans.size());
  EXPECT_GE(track.pieces[1].first_scan, log.begins[1]);
  EXPECT_LE(track.pieces[1].first_scan, log.begins[1] + 10);
  // No closure ties the two buildings to each other.
  for (const MappedClosure& closure : track.closures) {
    EXPECT_FALSE(closure.closure.is_accepted && closure.scan_i < log.begins[1] &&
                 closure.scan_j >= log.begins[1]);
  }
  // Each piece is a separate map.
  const std::size_t first = track.pieces[1].first_scan;
  expect_true_poses(track, log, first, first, log.scans.size());
}

TEST(MapperPieces, OdometryTiesThem) {
  LogWithHoles log = carried_elsewhere();
  // Driven without scans, but with odometry, to a room 30 m away, in a minute.
  for (std::size_t i = log.begins[1]; i < log.truth.size(); ++i) {
    log.scans[i].stamp.ns += 60'000'000'000;
    log.truth[i] = Pose2{30.0, 5.0, 0.0} * log.truth[i];
  }
  const Map track = map_of(log, {}, true);
  ASSERT_EQ(track.pieces.size(), 1U);
  EXPECT_TRUE(track.pieces[0].is_joined);
  for (std::size_t i = 0; i < log.truth.size(); i += 5) {
    EXPECT_THAT(between(track.scans[0].T_map_sensor, track.scans[i].T_map_sensor),
                PoseNear(between(log.truth[0], log.truth[i]),
                         PoseTolerance{.translation_m = 0.15, .rotation_rad = rad_from_deg(0.7)}))
        << i;
  }
}

/// The wheels do not know that the robot was carried: they go on where they were.
std::vector<Pose2> unaware_wheels(const LogWithHoles& log) {
  std::vector<Pose2> wheels{log.truth[0]};
  for (std::size_t i = 1; i < log.truth.size(); ++i) {
    const bool is_hole = std::ranges::find(log.begins, i) != log.begins.end();
    wheels.push_back(is_hole ? wheels.back()
                             : wheels.back() * between(log.truth[i - 1], log.truth[i]));
  }
  return wheels;
}

Map map_of_carried(const LogWithHoles& log, const MapperParams& params) {
  const std::vector<Pose2> wheels = unaware_wheels(log);
  Mapper mapper(params);
  for (std::size_t i = 0; i < log.scans.size(); ++i) mapper.add(log.scans[i], wheels[i]);
  return mapper.finish();
}

TEST(MapperPieces, OdometryThatStoodStillTiesNothing) {
  const Map elsewhere = map_of_carried(carried_elsewhere(), {});
  EXPECT_EQ(elsewhere.pieces.size(), 2U);
  EXPECT_EQ(elsewhere.odometry.num_carried, 1U);
  const LogWithHoles log = carried_away_and_back();
  const Map back = map_of_carried(log, {});
  ASSERT_EQ(back.pieces.size(), 3U);
  EXPECT_FALSE(back.pieces[1].is_joined);
  EXPECT_TRUE(back.pieces[2].is_joined);
  expect_true_poses(back, log, 0, back.pieces[2].first_scan, log.scans.size());
}

/// The rule switched off: wheels never stand still.
TEST(MapperPieces, OdometryThatStoodStillTiesWronglyWhereItIsBelieved) {
  MapperParams params;
  params.tracker.odometry.wheels_at_rest_m = 0.0;
  EXPECT_LT(map_of_carried(carried_elsewhere(), params).pieces.size(), 2U);
}

TEST(MapperPieces, OdometryThatBeginsBehindTheHoleTiesNothing) {
  const LogWithHoles log = carried_elsewhere();
  const std::size_t restart = map_of(log, {}).pieces.at(1).first_scan;
  Mapper mapper;
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    mapper.add(log.scans[i], i >= restart ? std::optional(log.truth[i]) : std::nullopt);
  }
  const Map track = mapper.finish();
  ASSERT_EQ(track.pieces.size(), 2U);
  EXPECT_EQ(track.pieces[1].first_scan, restart);
  EXPECT_FALSE(track.scans[restart].has_odometry) << "its place before is unknown";
  EXPECT_TRUE(track.scans[restart + 1].has_odometry);
}

TEST(MapperPieces, ManyThreadsGiveTheSameBits) {
  const LogWithHoles log = carried_away_and_back();
  MapperParams with_three;
  with_three.num_threads = 3;
  const Map one = map_of(log, {});
  const Map three = map_of(log, with_three);
  ASSERT_EQ(one.scans.size(), three.scans.size());
  for (std::size_t i = 0; i < one.scans.size(); ++i) {
    ASSERT_EQ(one.scans[i].T_map_base, three.scans[i].T_map_base) << i;
  }
  ASSERT_EQ(one.closures.size(), three.closures.size());
  for (std::size_t i = 0; i < one.closures.size(); ++i) {
    EXPECT_EQ(one.closures[i].closure.weight, three.closures[i].closure.weight);
    EXPECT_EQ(one.closures[i].closure.T_i_j, three.closures[i].closure.T_i_j);
  }
}

TEST(MapperPieces, FinishingTwiceGivesTheSame) {
  const LogWithHoles log = carried_away_and_back();
  Mapper mapper;
  for (const Scan& scan : log.scans) mapper.add(scan);
  const Map first = mapper.finish();
  const Map second = mapper.finish();
  ASSERT_EQ(first.scans.size(), second.scans.size());
  for (std::size_t i = 0; i < first.scans.size(); ++i) {
    ASSERT_EQ(first.scans[i].T_map_base, second.scans[i].T_map_base);
  }
  EXPECT_EQ(first.closures.size(), second.closures.size());
  EXPECT_EQ(first.graph.T_map_node, second.graph.T_map_node);
}

TEST(MapperPieces, ARobotThatStandsKeepsOneKeyframe) {
  // Memory grows with the way, not with the time.
  const auto walls = testing::l_shaped_room();
  Mapper mapper;
  for (const Scan& scan :
       scans_on_drive(walls, std::vector<Pose2>(400, {2.0, 3.0, 0.4}), kNoise_m)) {
    mapper.add(scan);
  }
  const Map track = mapper.finish();
  EXPECT_EQ(track.scans.size(), 400U);
  EXPECT_EQ(track.keyframes.size(), 1U);
}

}  // namespace setsquare::mapper_pieces_test
