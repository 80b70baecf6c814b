// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Wings at small angles to each other: their walls turn as after a slip of tracking, and matches of
// scans about the joint tell that it was none. Kind of place: buildings that are not square
// throughout, by less than what tracking may slip.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "tests/mapping/tracked_world.hpp"

namespace setsquare::mapper_wings_test {

using testing::Wall;

constexpr std::uint64_t kNumSeeds = 4;
constexpr double kHalf_m = 1.2;     ///< Of the corridors.
constexpr double kLength_m = 18.0;  ///< Of each wing.

/// One wall of a wing along x, with bays open to the corridor.
void add_side(double side, std::mt19937_64& random, std::vector<Wall>& walls) {
  std::uniform_real_distribution<double> size_m(1.5, 3.5);
  const double y_m = side * kHalf_m;
  double x_m = 0.0;
  while (x_m + 7.0 < kLength_m) {
    const double begin_m = x_m + 0.4 * size_m(random);
    const double end_m = begin_m + size_m(random);
    const double back_m = y_m + side * size_m(random);
    walls.insert(walls.end(),
                 {{x_m, y_m, begin_m, y_m},
                  {begin_m, y_m, begin_m, back_m},
                  {begin_m, back_m, end_m, back_m},
                  {end_m, back_m, end_m, y_m}});
    x_m = end_m;
  }
  walls.push_back({x_m, y_m, kLength_m, y_m});
}

/// A robot's way through two wings and back, and the map by its scans alone.
struct Drive {
  Drive(std::uint64_t seed, double angle_rad);

  std::vector<Pose2> truth;
  std::vector<Scan> scans;
};

Drive::Drive(std::uint64_t seed, double angle_rad) {
  std::mt19937_64 random(seed);
  std::vector<Wall> walls{{0.0, -kHalf_m, 0.0, kHalf_m}};
  std::vector<Wall> second{{kLength_m, -kHalf_m, kLength_m, kHalf_m}};
  for (const double side : {-1.0, 1.0}) {
    add_side(side, random, walls);
    add_side(side, random, second);
  }
  const Pose2 T_first_second{kLength_m, 0.0, angle_rad};
  second = testing::moved(second, T_first_second);
  walls.insert(walls.end(), second.begin(), second.end());
  const Eigen::Vector2d end_m = T_first_second * Eigen::Vector2d(kLength_m - 1.0, 0.0);
  truth = testing::drive({{1.0, 0.0}, {kLength_m, 0.0}, end_m, {kLength_m, 0.2}, {1.0, 0.2}});
  scans = testing::scans_on_drive(walls, truth, 0.01, testing::kAllAround);
}

/// The largest error of a heading, apart from what all have in common with the first.
double worst_heading_rad(const Drive& drive, const MapperParams& params) {
  Mapper mapper(params);
  for (const Scan& scan : drive.scans) mapper.add(scan);
  const Map map = mapper.finish();
  double worst_rad = 0.0;
  for (std::size_t i = 0; i < map.scans.size(); ++i) {
    const double turned_rad = map.scans[i].T_map_sensor.theta_rad - drive.truth[i].theta_rad -
                              map.scans[0].T_map_sensor.theta_rad + drive.truth[0].theta_rad;
    worst_rad = std::max(worst_rad, std::abs(wrap_to_pi(turned_rad)));
  }
  return worst_rad;
}

TEST(MapperWings, AtSmallAnglesAreNoSlips) {
  for (std::uint64_t seed = 1; seed <= kNumSeeds; ++seed) {
    const double angle_deg = (seed % 2 == 0 ? 1.0 : -1.0) * (4.0 + 2.5 * static_cast<double>(seed));
    const Drive drive(seed, rad_from_deg(angle_deg));
    EXPECT_LT(worst_heading_rad(drive, {}), rad_from_deg(1.0)) << seed << ": " << angle_deg;
  }
}

/// Nothing tells wings from slips but how far tracking would have slipped.
MapperParams without_matches() {
  MapperParams params;
  params.turns.max_rounds = 0;
  params.audit.is_on = false;
  return params;
}

double worst_of_nine_degrees_rad(std::uint64_t seed, const MapperParams& params) {
  return worst_heading_rad(Drive(seed, rad_from_deg(9.0)), params);
}

// Where no match decides, tracking that would have slipped by many standard deviations did not.
TEST(MapperWings, AreNoSlipsOfTrackingThatHardlyErrs) {
  for (std::uint64_t seed = 1; seed <= kNumSeeds; ++seed) {
    EXPECT_LT(worst_of_nine_degrees_rad(seed, without_matches()), rad_from_deg(1.0)) << seed;
  }
}

TEST(MapperWings, AreTakenForSlipsWithoutBoth) {
  MapperParams params = without_matches();
  params.turns.unlikely_slip_sigmas = 1e3;
  for (std::uint64_t seed = 1; seed <= kNumSeeds; ++seed) {
    EXPECT_GT(worst_of_nine_degrees_rad(seed, params), rad_from_deg(3.0)) << seed;
  }
}

/// Nothing tells wings from slips, nor does what contradicts the map decide a turn.
MapperParams of_walls_alone() {
  MapperParams params = without_matches();
  params.turns.unlikely_slip_sigmas = 1e3;
  params.turns.agreeing_rad = 1e-6;
  params.audit.is_on = true;
  return params;
}

// Walls that were taken for the wrong ones are outvoted by scans that see the joint from both
// sides.
TEST(MapperWings, AreOutvotedWhereTheWallsAreTakenForOthers) {
  for (std::uint64_t seed = 11; seed < 11 + kNumSeeds; ++seed) {
    const double angle_deg =
        (seed % 2 == 0 ? 1.0 : -1.0) * (5.0 + 2.6 * static_cast<double>(seed - 11));
    const Drive drive(seed, rad_from_deg(angle_deg));
    MapperParams params = of_walls_alone();
    EXPECT_LT(worst_heading_rad(drive, params), rad_from_deg(1.0)) << seed << ": " << angle_deg;
    params.outvoted.is_on = false;
    EXPECT_GT(worst_heading_rad(drive, params), rad_from_deg(2.5)) << seed << ": " << angle_deg;
  }
}

}  // namespace setsquare::mapper_wings_test
