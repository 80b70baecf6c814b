// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/pieces/piece_joining.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "setsquare/core/error.hpp"
#include "setsquare/mapping/pieces/known_joints.hpp"
#include "tests/mapping/tracked_world.hpp"
#include "tests/support/pose_matchers.hpp"

namespace setsquare::piece_joining_test {

using testing::between;
using testing::drive;
using testing::spaced;
using testing::Wall;

/// A piece of track: its own odom frame, in which the map's heading is unknown, too.
struct Piece {
  std::vector<Wall> walls;
  std::vector<Pose2> T_world_sensor;
  Pose2 T_odom_world;  ///< By tracking.
  Pose2 T_map_world;   ///< As the pieces are laid out before they are joined.
};

struct PiecedTrack {
  KeyframeTrack track;
  std::vector<Pose2> T_map_sensor;
};

/// Pieces one after the other. Each scan has independent noise.
PiecedTrack lay_out(const std::vector<Piece>& pieces) {
  PiecedTrack all;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    for (const Pose2& T_world_sensor : pieces[p].T_world_sensor) {
      const std::size_t k = all.track.size();
      const Scan scan =
          scan_of_walls(pieces[p].walls, T_world_sensor, testing::kAllAround, 0.01, k + 1);
      all.track.keyframes.push_back(
          testing::make_keyframe(scan, pieces[p].T_odom_world * T_world_sensor, k));
      all.track.motions.push_back(testing::small_covariance());
      all.track.stretches.push_back(p);
      all.track.pieces.push_back(p);
      all.T_map_sensor.push_back(pieces[p].T_map_world * T_world_sensor);
    }
  }
  return all;
}

JoinedPieces join(const PiecedTrack& pieced,
                  std::size_t num_threads = 1,
                  const PieceJoiningParams& params = {}) {
  return join_pieces(pieced.track, pieced.T_map_sensor, {}, {}, params, num_threads);
}

std::vector<Pose2> round_the_room() { return spaced(drive(testing::way_around_the_room())); }

/// Another way in the same room.
std::vector<Pose2> across_the_room() {
  return spaced(drive({{2.0, 7.5}, {1.5, 5.0}, {2.5, 2.0}, {5.5, 2.5}, {3.0, 1.0}}));
}

TEST(PieceJoining, FindsTheRoomAgainWhereverTrackingPutIt) {
  for (const Pose2& T_lost : {Pose2{30.0, -7.0, 0.5 * kPi}, Pose2{-5.0, 40.0, 2.0}, Pose2{}}) {
    const PiecedTrack pieced =
        lay_out({{testing::l_shaped_room(), round_the_room(), {}, {}},
                 {testing::l_shaped_room(), across_the_room(), {4.0, 5.0, -1.0}, T_lost}});
    const JoinedPieces joined = join(pieced);
    ASSERT_EQ(joined.is_joined, (std::vector<bool>{true, true}));
    EXPECT_EQ(joined.turn_rad[0], 0.0);
    // The second's tracked headings were off by -1 rad.
    EXPECT_NEAR(wrap_to_pi(joined.turn_rad[1] - 1.0), 0.0, rad_from_deg(0.5));
    const std::size_t num_first = round_the_room().size();
    const std::vector<Pose2> first = round_the_room();
    const std::vector<Pose2> second = across_the_room();
    ASSERT_GE(joined.joints.size(), 3U);
    for (const ComparedPlaces& joint : joined.joints) {
      ASSERT_LT(joint.from, num_first);
      ASSERT_GE(joint.to, num_first);
      EXPECT_EQ(joint.verdict.reason, ClosureReason::kStandsAlone);
      EXPECT_THAT(joint.T_from_to,
                  testing::PoseNear(between(first[joint.from], second[joint.to - num_first]),
                                    testing::PoseTolerance{.translation_m = 0.03,
                                                           .rotation_rad = rad_from_deg(0.5)}));
    }
  }
}

TEST(PieceJoining, WhatHasNothingInCommonStaysApart) {
  std::vector<Wall> elsewhere = testing::corridor_around_a_block();
  const PiecedTrack pieced =
      lay_out({{testing::l_shaped_room(), round_the_room(), {}, {}},
               {elsewhere, spaced(drive({{1.0, 1.0}, {15.0, 1.0}})), {}, {50.0, 0.0, 0.0}}});
  const JoinedPieces joined = join(pieced);
  EXPECT_EQ(joined.is_joined, (std::vector<bool>{true, false}));
  EXPECT_TRUE(joined.joints.empty());
  EXPECT_EQ(joined.turn_rad[1], 0.0);
}

/// Two equal rooms, door to door, and nothing that distinguishes them.
std::vector<Wall> twin_rooms() {
  std::vector<Wall> walls = testing::l_shaped_room();
  const std::vector<Wall> twin = testing::moved(walls, {40.0, 0.0, 0.0});
  walls.insert(walls.end(), twin.begin(), twin.end());
  return walls;
}

TEST(PieceJoining, OfTwoRoomsThatAreAlikeItTakesNeither) {
  // The first piece has been in both; the second is in one of them, and it is unknown in which.
  std::vector<Pose2> in_both = round_the_room();
  for (const Pose2& pose : round_the_room()) in_both.push_back(Pose2{40.0, 0.0, 0.0} * pose);
  const PiecedTrack pieced = lay_out(
      {{twin_rooms(), in_both, {}, {}}, {twin_rooms(), across_the_room(), {}, {9.0, 3.0, 1.0}}});
  const JoinedPieces joined = join(pieced);
  EXPECT_EQ(joined.is_joined, (std::vector<bool>{true, false}));
  EXPECT_TRUE(joined.joints.empty());
}

// The robot left the room along a bare corridor, and nobody knows how far: what is seen behind may
// be the room again or one like it.
TEST(PieceJoining, ARoomBehindAnOpenStretchIsNotTakenForOneLikeIt) {
  PiecedTrack pieced =
      lay_out({{testing::l_shaped_room(), round_the_room(), {}, {}},
               {testing::l_shaped_room(), across_the_room(), {}, {9.0, 3.0, 1.0}}});
  const PieceJoiningParams larger_than_the_room{.min_extent_m = 12.0};
  EXPECT_TRUE(join(pieced, 1, larger_than_the_room).is_joined[1]) << "no open stretch";
  pieced.track.motions[round_the_room().size()].open_sigma_m(0, 0) = 20.0;
  EXPECT_FALSE(join(pieced, 1, larger_than_the_room).is_joined[1]);
  EXPECT_TRUE(join(pieced, 1, {.min_extent_m = 0.0}).is_joined[1]) << "without the rule";
}

// A room like one of the map leads to a passage that the map's room has no space for.
TEST(PieceJoining, APieceIsNotJoinedWhereItSeesThroughTheMap) {
  const std::vector<Wall> passage{
      {1.0, 1.4, 5.0, 1.4}, {5.0, 1.4, 5.0, 2.6}, {5.0, 2.6, 1.0, 2.6}, {1.0, 2.6, 1.0, 1.4}};
  const std::vector<Pose2> up_and_down =
      spaced(drive({{1.5, 2.0}, {4.5, 2.0}, {1.5, 2.0}, {4.5, 2.0}}));
  std::vector<Pose2> twice_round = round_the_room();
  for (const Pose2& pose : round_the_room()) twice_round.push_back(pose);
  const Pose2 T_lost{9.0, 3.0, 1.0};
  PiecedTrack pieced = lay_out({{testing::l_shaped_room(), twice_round, {}, {}},
                                {testing::l_shaped_room(), across_the_room(), {}, T_lost},
                                {passage, up_and_down, {}, T_lost}});
  for (std::size_t& piece : pieced.track.pieces) piece = std::min<std::size_t>(piece, 1);
  EXPECT_FALSE(join(pieced).is_joined[1]);
  EXPECT_TRUE(join(pieced, 1, {.max_seen_through = 1.0}).is_joined[1]) << "without the rule";
}

/// The room and, 40 m off, its mirror image.
std::vector<Wall> room_and_mirror_image() {
  std::vector<Wall> walls = testing::l_shaped_room();
  for (const Wall& wall : testing::l_shaped_room()) {
    walls.push_back({wall.x1_m + 40.0, -wall.y1_m, wall.x2_m + 40.0, -wall.y2_m});
  }
  return walls;
}

std::vector<Pose2> in_the_mirror_image(std::vector<Pose2> poses) {
  for (Pose2& pose : poses) pose = {pose.x_m + 40.0, -pose.y_m, -pose.theta_rad};
  return poses;
}

TEST(PieceJoining, APieceMayHangOnOneThatIsJoinedAfterIt) {
  // The first has been in the room, the second in its mirror image, the last in both.
  std::vector<Pose2> long_way = round_the_room();
  for (const Pose2& pose : round_the_room()) long_way.push_back(pose);
  std::vector<Pose2> in_both = across_the_room();
  for (const Pose2& pose : in_the_mirror_image(across_the_room())) in_both.push_back(pose);
  const std::vector<Wall> walls = room_and_mirror_image();
  const PiecedTrack first_two =
      lay_out({{walls, long_way, {}, {}},
               {walls, in_the_mirror_image(round_the_room()), {}, {3.0, 60.0, 1.0}}});
  EXPECT_EQ(join(first_two).is_joined, (std::vector<bool>{true, false}));
  const PiecedTrack all =
      lay_out({{walls, long_way, {}, {}},
               {walls, in_the_mirror_image(round_the_room()), {}, {3.0, 60.0, 1.0}},
               {walls, in_both, {}, {-60.0, 3.0, 2.5}}});
  EXPECT_EQ(join(all).is_joined, (std::vector<bool>{true, true, true}));
}

TEST(PieceJoining, AnyNumberOfThreadsFindsTheSame) {
  const PiecedTrack pieced =
      lay_out({{testing::l_shaped_room(), round_the_room(), {}, {}},
               {testing::l_shaped_room(), across_the_room(), {}, {30.0, 0.0, 1.0}}});
  const JoinedPieces alone = join(pieced, 1);
  const JoinedPieces with_four = join(pieced, 4);
  ASSERT_FALSE(alone.joints.empty());
  EXPECT_EQ(alone.turn_rad, with_four.turn_rad);
  ASSERT_EQ(alone.joints.size(), with_four.joints.size());
  for (std::size_t i = 0; i < alone.joints.size(); ++i) {
    EXPECT_EQ(alone.joints[i].T_from_to, with_four.joints[i].T_from_to);
  }
}

TEST(PieceJoining, AsksForNoMorePlacesThanAllowed) {
  const PiecedTrack pieced =
      lay_out({{testing::l_shaped_room(), round_the_room(), {}, {}},
               {testing::l_shaped_room(), across_the_room(), {}, {30.0, 0.0, 1.0}}});
  for (std::size_t max_num_queries = 1; max_num_queries <= 6; ++max_num_queries) {
    const JoinedPieces joined = join_pieces(pieced.track,
                                            pieced.T_map_sensor,
                                            {},
                                            {},
                                            {.max_num_queries = max_num_queries, .min_agreeing = 1},
                                            1);
    std::set<std::size_t> sought;
    for (const ComparedPlaces& joint : joined.joints) sought.insert(joint.to);
    EXPECT_FALSE(sought.empty());
    EXPECT_LE(sought.size(), max_num_queries);
  }
}

TEST(PieceJoining, APieceOfFewPlacesStaysApart) {
  // A place stands every third keyframe: the ten of the second piece have no more than four.
  std::vector<Pose2> short_way = across_the_room();
  short_way.resize(10);
  const PiecedTrack pieced = lay_out({{testing::l_shaped_room(), round_the_room(), {}, {}},
                                      {testing::l_shaped_room(), short_way, {}, {30.0, 0.0, 1.0}}});
  const auto is_joined = [&](std::size_t min_agreeing) -> bool {
    const PieceJoiningParams params{.min_agreeing = min_agreeing};
    return join_pieces(pieced.track, pieced.T_map_sensor, {}, {}, params, 1).is_joined[1];
  };
  EXPECT_TRUE(is_joined(3));
  EXPECT_FALSE(is_joined(5));
}

/// The room, then two keyframes on the way back; `T_carried`: where tracking has these wrongly.
PiecedTrack broken_off(const Pose2& T_carried) {
  const std::vector<Pose2> around = round_the_room();
  const std::vector<Pose2> behind{around.end() - 2, around.end()};
  return lay_out({{testing::l_shaped_room(), {around.begin(), around.end() - 2}, {}, {}},
                  {testing::l_shaped_room(), behind, T_carried, T_carried}});
}

TEST(PieceJoining, AcrossABreakMatchesThatHaveTheRobotWhereTrackingHasItJoin) {
  const JoinedPieces joined = join(broken_off({}));
  EXPECT_EQ(joined.is_joined, (std::vector<bool>{true, true}));
  EXPECT_GE(joined.joints.size(), 2U);
}

TEST(PieceJoining, AcrossABreakMatchesAloneDoNot) {
  // The robot may have been carried, and another place may look like this one.
  const JoinedPieces joined = join(broken_off({2.0, 0.5, 0.1}));
  EXPECT_EQ(joined.is_joined, (std::vector<bool>{true, false}));
}

/// A break between key frames a metre apart: `lost_m` lies between the last before it and the first
/// behind it.
PiecedTrack broken_key_frames(double lost_m) {
  std::vector<Pose2> before;
  std::vector<Pose2> behind;
  for (int i = 0; i < 4; ++i) before.push_back({0.8 + i, 2.0, 0.0});
  for (int i = 0; i < 2; ++i) behind.push_back({3.8 + lost_m, 2.0 + i, 0.5 * kPi});
  PiecedTrack pieced = lay_out({{testing::l_shaped_room(), before, {}, {}},
                                {testing::l_shaped_room(), behind, {4.0, 5.0, -1.0}, {}}});
  for (MotionCovariance& motion : pieced.track.motions) motion.is_long_step = true;
  return pieced;
}

// Too few keyframes for places that agree: only that the robot goes a metre or two from one to the
// next tells.
TEST(PieceJoining, AcrossABreakOfKeyFramesTheMatchOfAStepJoins) {
  EXPECT_TRUE(join(broken_key_frames(1.2)).is_joined[1]);
  EXPECT_FALSE(join(broken_key_frames(1.2), 1, {.min_log_odds_across_break = 100.0}).is_joined[1])
      << "without the rule";
}

TEST(PieceJoining, AMatchFartherThanTheStepsAcrossABreakDoesNot) {
  PiecedTrack pieced = broken_key_frames(1.2);
  PieceJoiningParams params;
  params.steps.least_reach_m = 0.05;
  params.steps.least_reach_rad = rad_from_deg(1.0);
  params.steps.reach_per_step = 0.05;  // As if the robot went so far only.
  EXPECT_FALSE(join(pieced, 1, params).is_joined[1]);
}

// A direction that a match leaves open is not held by the joint.
TEST(PieceJoining, AJointHoldsWhatItsMatchDetermines) {
  const PieceJoiningParams params;
  const Eigen::Matrix3d full = information_of_joint(params);
  const Eigen::Matrix3d open = information_of_joint(params, 0.25 * kPi);
  const Eigen::Vector3d along(std::sqrt(0.5), std::sqrt(0.5), 0.0);
  const Eigen::Vector3d across(-std::sqrt(0.5), std::sqrt(0.5), 0.0);
  EXPECT_NEAR(across.dot(open * across), across.dot(full * across), 1e-9);
  EXPECT_NEAR(
      along.dot(open * along), 1.0 / (params.joint_open_sigma_m * params.joint_open_sigma_m), 1e-9);
  EXPECT_EQ(open(2, 2), full(2, 2));
}

TEST(PieceJoining, NoTrackNoPieces) { EXPECT_TRUE(join({}).is_joined.empty()); }

TEST(PieceJoining, RefusesParametersThatAreNone) {
  const PieceJoiningParams no_queries{.max_num_queries = 0};
  EXPECT_THROW(static_cast<void>(join_pieces({}, {}, {}, {}, no_queries, 1)), ParameterError);
}

}  // namespace setsquare::piece_joining_test
