// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/distinct_wall.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "setsquare/matching/match_params.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::distinct_wall_test {

using testing::uniform;

const testing::Fan kFullTurn{720, rad_from_deg(-180), rad_from_deg(0.5)};

PreparedScan look(const std::vector<testing::Wall>& walls, const Pose2& T, std::uint64_t seed) {
  return prepare(testing::scan_of_walls(walls, T, kFullTurn, 0.01, seed));
}

double distinct(const PreparedScan& reference, const PreparedScan& current, const Pose2& T) {
  return distinct_wall_m(reference.fine_alignment(), current.fine_alignment(), T);
}

/// Of two looks from one pose.
double distinct_from(const std::vector<testing::Wall>& walls, const Pose2& T_world_sensor) {
  return distinct(look(walls, T_world_sensor, 1), look(walls, T_world_sensor, 2), {});
}

const std::vector<testing::Wall> kCorner = {{0.0, 0.0, 10.0, 0.0}, {0.0, 0.0, 0.0, 10.0}};

/// Length of the samples that lie near a surface of the other scan, whichever way they face.
double near_wall_m(const SurfaceImage& image, const SurfaceSamples& samples, const Pose2& T_a_b) {
  double sum_m = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Eigen::Vector2d q = T_a_b * Eigen::Vector2d(samples.x_m[i], samples.y_m[i]);
    const auto x_m = static_cast<float>(q.x());
    const auto y_m = static_cast<float>(q.y());
    if (std::abs(SurfaceImage::signed_distance_m(image.at(x_m, y_m), x_m, y_m)) < 0.1501F) {
      sum_m += samples.weight_m[i];
    }
  }
  return sum_m;
}

TEST(DistinctWall, IsNeverMoreThanTheAgreeingWall) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 30; ++trial) {
    const auto room = testing::furnished_room(generator);
    const Pose2 a = testing::free_pose(room, generator);
    const Pose2 b = testing::free_pose(room, generator);
    const PreparedScan reference = look(room.walls, a, 1);
    const PreparedScan current = look(room.walls, b, 2);
    const Pose2 slip{uniform(generator, -0.3, 0.3), uniform(generator, -0.3, 0.3), 0.0};
    const Pose2 T = a.inverse() * b * slip;
    const double near_m = near_wall_m(reference.image(), current.fine, T) +
                          near_wall_m(current.image(), reference.fine, T.inverse());
    EXPECT_LE(distinct(reference, current, T), near_m + 1e-3);
  }
}

TEST(DistinctWall, IsNothingWhereNothingLiesOnTheOther) {
  const PreparedScan corner = look(kCorner, {3.0, 2.0, 0.0}, 1);
  EXPECT_LT(distinct(corner, corner, {40.0, 31.0, 0.3}), 0.1);
}

TEST(DistinctWall, IsOfARoomMuchMoreThanOfACorner) {
  auto generator = testing::make_generator();
  // Half a metre per line, a little more where a return lies off its wall.
  const double corner_m = distinct_from(kCorner, {3.0, 2.0, 0.0});
  EXPECT_GE(corner_m, 0.99);
  EXPECT_LE(corner_m, 1.3);
  constexpr int kNumRooms = 20;
  double mean_room_m = 0.0;
  for (int trial = 0; trial < kNumRooms; ++trial) {
    const auto room = testing::furnished_room(generator);
    const double room_m = distinct_from(room.walls, testing::free_pose(room, generator));
    EXPECT_GT(room_m, corner_m);
    mean_room_m += room_m / kNumRooms;
  }
  EXPECT_GT(mean_room_m, 3.0 * corner_m);
}

TEST(DistinctWall, OfACornerIsTooLittleWhereverTheSensorFaces) {
  for (int degrees = 0; degrees < 90; degrees += 3) {
    const double corner_m = distinct_from(kCorner, {3.0, 2.0, rad_from_deg(degrees)});
    EXPECT_GE(corner_m, 0.99) << degrees << " deg";
    EXPECT_LT(corner_m, AnswerParams{}.min_distinct_m) << degrees << " deg";
  }
}

TEST(DistinctWall, OfARoomHardlyDependsOnWhereTheSensorFaces) {
  auto generator = testing::make_generator();
  double largest_change = 0.0;
  for (int trial = 0; trial < 20; ++trial) {
    const auto room = testing::furnished_room(generator);
    Pose2 T = testing::free_pose(room, generator);
    const double before_m = distinct_from(room.walls, T);
    T.theta_rad = wrap_to_pi(T.theta_rad + uniform(generator, -kPi, kPi));
    const double change = std::abs(distinct_from(room.walls, T) / before_m - 1.0);
    largest_change = std::max(largest_change, change);
  }
  EXPECT_LT(largest_change, 0.35);
}

TEST(DistinctWall, FallsAsTheScansAreMovedApart) {
  auto generator = testing::make_generator();
  double together_m = 0.0;
  double apart_m = 0.0;
  for (int trial = 0; trial < 30; ++trial) {
    const auto room = testing::furnished_room(generator);
    const PreparedScan scan = look(room.walls, testing::free_pose(room, generator), 1);
    together_m += distinct(scan, scan, {});
    apart_m += distinct(scan, scan, {0.7, 0.6, 0.3});
  }
  EXPECT_LT(apart_m, 0.4 * together_m);
}

}  // namespace setsquare::distinct_wall_test
