// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Odometry that is none, or another's: from a furnished room through a bare corridor, where only
// the odometry tells how far, into another room. Every kind over several worlds, against the truth.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "tests/mapping/tracked_world.hpp"
#include "tests/support/rooms.hpp"

namespace setsquare::mapper_odometry_test {

using testing::between;
using testing::Wall;

constexpr std::uint64_t kNumSeeds = 4;
constexpr double kSeen_m = 6.0;  ///< Farther than this the scanner sees nothing.

/// A robot that drives through a world.
struct Drive {
  explicit Drive(std::uint64_t seed);

  std::vector<Pose2> truth;
  std::vector<Scan> scans;
};

/// A room of 6 m x 6 m with two boxes, its corner at (x, -3); `door_x` is its wall with a door.
void add_room(double x_m, double door_x_m, std::mt19937_64& random, std::vector<Wall>& walls) {
  const double end_m = x_m + 6.0;
  walls.insert(walls.end(), {{x_m, -3.0, end_m, -3.0}, {x_m, 3.0, end_m, 3.0}});
  const double back_x_m = door_x_m == x_m ? end_m : x_m;
  walls.push_back({back_x_m, -3.0, back_x_m, 3.0});
  walls.insert(walls.end(), {{door_x_m, -3.0, door_x_m, -1.0}, {door_x_m, 1.0, door_x_m, 3.0}});
  std::uniform_real_distribution<double> size_m(0.5, 1.2);
  for (const double side : {-1.0, 1.0}) {
    const double left_m = x_m + 1.5 + size_m(random);
    const double right_m = left_m + size_m(random);
    const double y_m = side * (3.0 - size_m(random));
    walls.insert(walls.end(),
                 {{left_m, 3.0 * side, left_m, y_m},
                  {left_m, y_m, right_m, y_m},
                  {right_m, y_m, right_m, 3.0 * side}});
  }
}

Drive::Drive(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const double length_m = std::uniform_real_distribution<double>(20.0, 30.0)(random);
  std::vector<Wall> walls{{0.0, -1.0, length_m, -1.0}, {0.0, 1.0, length_m, 1.0}};
  add_room(-6.0, 0.0, random, walls);
  add_room(length_m, length_m, random, walls);
  truth = testing::drive({{-4.5, -0.5},
                          {-2.0, -1.0},
                          {-1.5, 1.0},
                          {-4.5, 1.0},
                          {-1.5, 0.0},
                          {length_m + 1.5, 0.0},
                          {length_m + 2.0, 1.0},
                          {length_m + 4.5, 0.5}});
  scans = testing::scans_on_drive(walls, truth, 0.01, testing::kAllAround);
  for (Scan& scan : scans) scan.max_range_m = kSeen_m;
}

/// What wheels show: of each step, or of the pose that the steps before have added up to.
struct Fault {
  std::function<Pose2(const Pose2& step, std::size_t i)> step;
  OdometryVerdict verdict = OdometryVerdict::kBelieved;
};

std::vector<Pose2> wheels_of(const Drive& drive, const Fault& fault) {
  std::vector<Pose2> wheels{Pose2{}};
  for (std::size_t i = 1; i < drive.truth.size(); ++i) {
    wheels.push_back(wheels.back() * fault.step(between(drive.truth[i - 1], drive.truth[i]), i));
  }
  return wheels;
}

Map map_of(const Drive& drive, const std::vector<Pose2>& wheels, const MapperParams& params = {}) {
  Mapper mapper(params);
  for (std::size_t i = 0; i < drive.scans.size(); ++i) mapper.add(drive.scans[i], wheels[i]);
  return mapper.finish();
}

/// Whether a pose is off by more than 0.5 m and more than three times the spread told, or its
/// heading by more than 5 degrees.
bool is_wrong_and_silent(const Map& map, const Drive& drive) {
  for (std::size_t i = 0; i < map.scans.size(); ++i) {
    const MappedScan& scan = map.scans[i];
    if (!scan.is_placed) continue;
    const Pose2 off = between(between(drive.truth[0], drive.truth[i]),
                              between(map.scans[0].T_map_sensor, scan.T_map_sensor));
    const double off_m = std::hypot(off.x_m, off.y_m);
    if (off_m > std::max(0.5, 3.0 * scan.position_sigma_m)) return true;
    if (std::abs(off.theta_rad) > rad_from_deg(5.0)) return true;
  }
  return false;
}

std::size_t num_wrong_and_silent(const Fault& fault, const MapperParams& params = {}) {
  std::size_t num_wrong = 0;
  for (std::uint64_t seed = 1; seed <= kNumSeeds; ++seed) {
    const Drive drive(seed);
    const Map map = map_of(drive, wheels_of(drive, fault), params);
    num_wrong += is_wrong_and_silent(map, drive);
    EXPECT_TRUE(map.odometry.verdict == fault.verdict) << to_string(map.odometry.verdict);
  }
  return num_wrong;
}

Fault scaled(double way, double turn) {
  return {[=](const Pose2& step, std::size_t) {
            return Pose2{way * step.x_m, way * step.y_m, turn * step.theta_rad};
          },
          OdometryVerdict::kScaled};
}

/// Stands but for the last digits.
Fault trembling() {
  return {[](const Pose2&, std::size_t i) {
            return Pose2{i % 2 == 0 ? 1e-4 : -1e-4, 0.0, 0.0};
          },
          OdometryVerdict::kStill};
}

TEST(MapperOdometry, GoodOneIsBelieved) {
  EXPECT_EQ(num_wrong_and_silent({[](const Pose2& step, std::size_t) { return step; }}), 0U);
}

TEST(MapperOdometry, ScalesAreMended) {
  EXPECT_EQ(num_wrong_and_silent(scaled(0.5, 1.0)), 0U);
  EXPECT_EQ(num_wrong_and_silent(scaled(2.0, 1.0)), 0U);
  EXPECT_EQ(num_wrong_and_silent(scaled(100.0, 1.0)), 0U);
  EXPECT_EQ(num_wrong_and_silent(scaled(1.0, 2.0)), 0U);
}

TEST(MapperOdometry, OneThatStandsIsIgnored) { EXPECT_EQ(num_wrong_and_silent(trembling()), 0U); }

TEST(MapperOdometry, OneThatTurnsTheOtherWayIsIgnored) {
  EXPECT_EQ(num_wrong_and_silent({[](const Pose2& step, std::size_t) {
                                    return Pose2{step.x_m, -step.y_m, -step.theta_rad};
                                  },
                                  OdometryVerdict::kMirrored}),
            0U);
}

TEST(MapperOdometry, AJumpIsIgnored) {
  EXPECT_EQ(num_wrong_and_silent({[](const Pose2& step, std::size_t i) {
              return i % 150 == 100 ? step * Pose2{3.0, 1.0, 0.5} : step;
            }}),
            0U);
}

/// The rule switched off.
TEST(MapperOdometry, IsBelievedWronglyWithoutTrial) {
  MapperParams params;
  params.tracker.odometry.is_on = false;
  Fault twice = scaled(2.0, 1.0);
  twice.verdict = OdometryVerdict::kOpen;
  EXPECT_EQ(num_wrong_and_silent(twice, params), kNumSeeds);
  Fault still = trembling();
  still.verdict = OdometryVerdict::kOpen;
  EXPECT_EQ(num_wrong_and_silent(still, params), kNumSeeds);
}

/// A round hall, empty but for the wall, whose radius the seed draws; a way through it.
Drive drive_in_a_round_hall(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const double radius_m = std::uniform_real_distribution<double>(5.0, 9.0)(random);
  Drive drive(seed);
  drive.truth = testing::drive({{-3.0, 0.0}, {0.5, -2.0}, {3.0, 0.5}, {-1.0, 3.0}, {-3.0, 0.0}});
  drive.scans = testing::scans_on_drive(
      testing::regular_polygon(120, radius_m), drive.truth, 0.01, testing::kAllAround);
  return drive;
}

/// The largest error of a pose: in m, and of its heading.
Pose2 largest_error(const Map& map, const Drive& drive) {
  Pose2 largest;
  for (std::size_t i = 0; i < map.scans.size(); ++i) {
    const Pose2 off = between(between(drive.truth[0], drive.truth[i]),
                              between(map.scans[0].T_map_sensor, map.scans[i].T_map_sensor));
    largest.x_m = std::max(largest.x_m, std::hypot(off.x_m, off.y_m));
    largest.theta_rad = std::max(largest.theta_rad, std::abs(off.theta_rad));
  }
  return largest;
}

TEST(MapperOdometry, HoldsTheHeadingInARoundHall) {
  for (std::uint64_t seed = 1; seed <= kNumSeeds; ++seed) {
    const Drive drive = drive_in_a_round_hall(seed);
    const Pose2 error = largest_error(map_of(drive, drive.truth), drive);
    EXPECT_LT(error.x_m, 0.1) << seed;
    EXPECT_LT(error.theta_rad, rad_from_deg(1.0)) << seed;
  }
}

/// The rule switched off: every turn is taken to be bound. One hall: without the rule the mapper
/// takes a minute for four.
TEST(MapperOdometry, DoesNotHoldItWhereTheWallsAreBelieved) {
  MapperParams params;
  params.tracker.refinement.turn = {.noise_rad = 0.0, .bound_rad = 1e-6};
  const Drive drive = drive_in_a_round_hall(1);
  const Pose2 error = largest_error(map_of(drive, drive.truth, params), drive);
  EXPECT_GT(error.theta_rad, rad_from_deg(5.0));
}

}  // namespace setsquare::mapper_odometry_test
