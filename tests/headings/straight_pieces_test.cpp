// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/headings/straight_pieces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "setsquare/core/angle.hpp"
#include "setsquare/scan/scan_to_points.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare::straight_pieces_test {

constexpr double kStep_rad = rad_from_deg(0.5);
const testing::Fan kFan{720, -kPi, kStep_rad};

std::vector<StraightPiece> pieces_of(const std::vector<testing::Wall>& walls,
                                     const Pose2& T_world_sensor,
                                     double noise_m = 0.0) {
  const Scan scan = testing::scan_of_walls(walls, T_world_sensor, kFan, noise_m);
  return straight_pieces(points_from_scan(scan), scan.bearing_step_rad);
}

TEST(StraightPieces, AnExactWallIsOnePieceOfItsDirection) {
  const auto pieces = pieces_of({{-2.0, 1.0, 3.0, 2.0}}, {});
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_NEAR(wrap_to_period(pieces[0].direction_rad - std::atan2(1.0, 5.0), kPi), 0.0, 1e-9);
  EXPECT_NEAR(pieces[0].rms_m, 0.0, 1e-7);
}

TEST(StraightPieces, LengthIsThatOfAnEvenlyFilledPiece) {
  PointSet points;
  for (int i = 0; i <= 200; ++i) points.push_back(1.0 + 0.02 * i, 2.0 - 0.01 * i, i);
  const auto pieces = straight_pieces(points, kStep_rad);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_NEAR(pieces[0].length_m, std::hypot(4.0, 2.0), 0.03);
  EXPECT_NEAR(pieces[0].center_x_m, 3.0, 1e-12);
  EXPECT_NEAR(pieces[0].center_y_m, 1.0, 1e-12);
  double spread_m2 = 0.0;
  for (int i = -100; i <= 100; ++i) spread_m2 += 0.0005 * i * i;
  EXPECT_NEAR(pieces[0].spread_m2, spread_m2, 1e-9);
}

TEST(StraightPieces, ASquareRoomHasFourLongOnes) {
  const std::vector<testing::Wall> room = {
      {-3, -2, 3, -2}, {3, -2, 3, 2}, {3, 2, -3, 2}, {-3, 2, -3, -2}};
  int num_long = 0;
  for (const StraightPiece& piece : pieces_of(room, {0.4, 0.3, 0.2})) {
    if (piece.length_m < 1.0) continue;  // A corner, or the part of a wall where the fan begins.
    ++num_long;
    EXPECT_NEAR(wrap_to_period(piece.direction_rad + 0.2, 0.5 * kPi), 0.0, rad_from_deg(0.5));
  }
  EXPECT_GE(num_long, 4);
  EXPECT_LE(num_long, 5);
}

TEST(StraightPieces, PartsAtAGapAndNotAtASkippedBeam) {
  PointSet points;
  for (int i = 0; i < 40; ++i) {
    if (i == 10 || i == 11) continue;  // Two beams without a return.
    if (i >= 20 && i < 28) continue;   // A door.
    points.push_back(0.05 * i - 1.0, 2.0, i);
  }
  EXPECT_EQ(straight_pieces(points, kStep_rad).size(), 2U);
}

TEST(StraightPieces, TheToleranceGrowsWithTheScansNoise) {
  const std::vector<testing::Wall> wall = {{-2.0, 2.0, 2.0, 2.0}};
  const Scan scan = testing::scan_of_walls(wall, {}, kFan, 0.025);
  const PointSet points = points_from_scan(scan);
  const auto num_pieces = [&points](const StraightPieceParams& params) {
    return straight_pieces(points, kStep_rad, params).size();
  };
  EXPECT_LE(num_pieces({}), 5U);
  EXPECT_GT(num_pieces({.max_tolerance_m = 0.05}), 2 * num_pieces({}));
}

TEST(SurfaceNoise, IsMeasuredWithinATenth) {
  std::mt19937_64 generator(7);
  for (const double sigma_m : {0.005, 0.02, 0.05}) {
    std::normal_distribution<double> noise(0.0, sigma_m);
    PointSet points;
    for (int i = 0; i < 4000; ++i) points.push_back(0.2 * i, noise(generator), i);
    EXPECT_NEAR(surface_noise_m(points, 0.2), sigma_m, 0.1 * sigma_m);
  }
}

TEST(StraightPieces, OfNoPointsAndOfPointsInOnePlaceAreHarmless) {
  EXPECT_TRUE(straight_pieces(PointSet{}, kStep_rad).empty());
  EXPECT_EQ(surface_noise_m(PointSet{}, 0.2), 0.0);
  PointSet same;
  for (int i = 0; i < 20; ++i) same.push_back(1.0, 1.0, i);
  for (const StraightPiece& piece : straight_pieces(same, kStep_rad)) {
    EXPECT_EQ(piece.length_m, 0.0);
  }
}

}  // namespace setsquare::straight_pieces_test
