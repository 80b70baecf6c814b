// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/pieces/twin.hpp"

#include <gtest/gtest.h>

#include "tests/mapping/tracked_world.hpp"

namespace setsquare::twin_test {

using testing::drive;
using testing::spaced;
using testing::Wall;

/// A room with a door onto a corridor, or else onto a hall.
std::vector<Wall> room_on(bool is_corridor) {
  std::vector<Wall> walls{{0.0, 0.0, 4.0, 0.0},
                          {5.0, 0.0, 6.0, 0.0},
                          {6.0, 0.0, 6.0, 5.0},
                          {6.0, 5.0, 0.0, 5.0},
                          {0.0, 5.0, 0.0, 0.0},
                          {1.0, 5.0, 1.0, 4.4},
                          {1.0, 4.4, 2.0, 4.4},
                          {2.0, 4.4, 2.0, 5.0}};
  const double y_m = is_corridor ? -2.0 : -6.0;
  const std::vector<Wall> corridor{
      {3.0, y_m, 16.0, y_m}, {3.0, y_m, 3.0, 0.0}, {6.0, 0.0, 16.0, 0.0}, {16.0, y_m, 16.0, 0.0}};
  walls.insert(walls.end(), corridor.begin(), corridor.end());
  return walls;
}

const std::vector<Eigen::Vector2d> kWay{
    {1.0, 1.0}, {3.0, 4.0}, {4.5, 2.0}, {4.5, -1.0}, {9.0, -1.0}};

/// A piece that was in the room on the corridor, and one that was in its twin on a hall, or there
/// again.
struct TwoPieces {
  explicit TwoPieces(bool is_twin) {
    add(room_on(true), kWay, 0);
    num_known = track.size();
    add(room_on(!is_twin), kWay, 1);
  }
  void add(const std::vector<Wall>& walls,
           const std::vector<Eigen::Vector2d>& way,
           std::size_t piece) {
    for (const Pose2& pose : spaced(drive(way))) {
      const std::size_t k = track.size();
      const Scan scan = scan_of_walls(walls, pose, testing::kAllAround, 0.01, k + 1);
      track.keyframes.push_back(testing::make_keyframe(scan, pose, k));
      track.motions.push_back(testing::small_covariance());
      track.stretches.push_back(piece);
      track.pieces.push_back(piece);
      T_map_sensor.push_back(pose);
    }
  }
  /// Every third keyframe in the room says that the second piece lies where it lies.
  [[nodiscard]] bool may_be_twin(const PieceJoiningParams& params = {}) const {
    JoiningClaim claim{.T_map_piece = {}, .places = {}, .known = {}, .piece = {}};
    for (std::size_t k = 0; k < track.size(); ++k) {
      claim.known.push_back(k < num_known);
      claim.piece.push_back(k >= num_known);
      const bool is_in_room = T_map_sensor[k].y_m > 0.0;
      if (k >= num_known && is_in_room && k % 3 == 0) claim.places.push_back(k);
    }
    return setsquare::may_be_twin(claim, track, T_map_sensor, params);
  }
  KeyframeTrack track;
  std::vector<Pose2> T_map_sensor;
  std::size_t num_known = 0;
};

/// The places of the room lie 4 m apart.
const PieceJoiningParams kOfOneRoom{.min_extent_m = 3.0};

TEST(Twin, IsToldByTheCorridorThatItLiesOn) {
  EXPECT_TRUE(TwoPieces(true).may_be_twin(kOfOneRoom));
  EXPECT_FALSE(TwoPieces(false).may_be_twin(kOfOneRoom));
}

TEST(Twin, IsNotToldByTheRoomAlone) {
  // As far as one room goes, each may be one.
  EXPECT_TRUE(TwoPieces(false).may_be_twin({.min_extent_m = 5.0}));
}

/// The rule switched off: any share may be seen through.
TEST(Twin, PassesWhereItsCorridorIsNotLookedAt) {
  PieceJoiningParams params = kOfOneRoom;
  params.max_seen_through = 1.0;
  EXPECT_FALSE(TwoPieces(true).may_be_twin(params));
}

TEST(Twin, MovesWithThePiece) {
  TwoPieces pieces(true);
  const Pose2 T{30.0, -7.0, 2.0};
  JoiningClaim claim{.T_map_piece = T.inverse(), .places = {}, .known = {}, .piece = {}};
  for (std::size_t k = 0; k < pieces.track.size(); ++k) {
    claim.known.push_back(k < pieces.num_known);
    claim.piece.push_back(k >= pieces.num_known);
    if (!claim.piece[k]) continue;
    if (pieces.T_map_sensor[k].y_m > 0.0 && k % 3 == 0) claim.places.push_back(k);
    pieces.T_map_sensor[k] = T * pieces.T_map_sensor[k];
  }
  EXPECT_TRUE(may_be_twin(claim, pieces.track, pieces.T_map_sensor, kOfOneRoom));
  claim.places.clear();
  EXPECT_TRUE(may_be_twin(claim, pieces.track, pieces.T_map_sensor, kOfOneRoom)) << "no places";
}

}  // namespace setsquare::twin_test
