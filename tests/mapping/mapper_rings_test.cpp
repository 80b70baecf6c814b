// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Loops through bare corridors, by the scans alone: the robot stops and drives on at another speed
// where nothing tells how far it gets. Kinds of place: rooms that differ at the corners of a ring;
// and a spiral that leads to an exact twin of its first room, which is none.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "tests/mapping/tracked_world.hpp"

namespace setsquare::mapper_rings_test {

using testing::Wall;

constexpr double kHalf_m = 1.1;   ///< Of the corridors.
constexpr double kSight_m = 8.0;  ///< Of the scanner.
constexpr std::uint64_t kNumSeeds = 2;

/// A room about (0, 0): its sides, and a cupboard in each corner.
struct Room {
  explicit Room(std::mt19937_64& random) {
    std::uniform_real_distribution<double> half_m(2.2, 3.8);
    std::uniform_real_distribution<double> size_m(0.4, 1.1);
    for (double& side : sides_m) side = half_m(random);
    for (Eigen::Vector2d& cupboard : cupboards_m) cupboard = {size_m(random), size_m(random)};
  }
  double sides_m[4] = {};  ///< Towards +x, +y, -x, -y.
  Eigen::Vector2d cupboards_m[4];
};

/// Directions in which a room has a corridor, as bits: +x, +y, -x, -y.
enum Doors : unsigned { kEast = 1, kNorth = 2, kWest = 4, kSouth = 8 };

void add_room(const Room& room, const Eigen::Vector2d& at, unsigned doors, std::vector<Wall>& to) {
  const Eigen::Vector2d low(-room.sides_m[2], -room.sides_m[3]);
  const Eigen::Vector2d high(room.sides_m[0], room.sides_m[1]);
  const auto add = [&](double x1, double y1, double x2, double y2) {
    to.push_back({at.x() + x1, at.y() + y1, at.x() + x2, at.y() + y2});
  };
  const auto side = [&](unsigned door, auto wall) {
    if ((doors & door) == 0) return wall(-10.0, 10.0);
    wall(-10.0, -kHalf_m);
    wall(kHalf_m, 10.0);
  };
  const auto along_x = [&](double y_m) {
    return [&add, low, high, y_m](double a, double b) {
      add(std::max(a, low.x()), y_m, std::min(b, high.x()), y_m);
    };
  };
  const auto along_y = [&](double x_m) {
    return [&add, low, high, x_m](double a, double b) {
      add(x_m, std::max(a, low.y()), x_m, std::min(b, high.y()));
    };
  };
  side(kEast, along_y(high.x()));
  side(kWest, along_y(low.x()));
  side(kNorth, along_x(high.y()));
  side(kSouth, along_x(low.y()));
  for (int corner = 0; corner < 4; ++corner) {
    const double x_m = corner % 2 == 0 ? low.x() : high.x();
    const double y_m = corner / 2 == 0 ? low.y() : high.y();
    const double to_x_m = x_m - std::copysign(room.cupboards_m[corner].x(), x_m);
    const double to_y_m = y_m - std::copysign(room.cupboards_m[corner].y(), y_m);
    add(to_x_m, y_m, to_x_m, to_y_m);
    add(to_x_m, to_y_m, x_m, to_y_m);
  }
}

/// A bare corridor from the middle of one room to that of another, without its ends in them.
void add_corridor(const Eigen::Vector2d& a,
                  const Room& room_a,
                  const Eigen::Vector2d& b,
                  const Room& room_b,
                  std::vector<Wall>& to) {
  const bool is_along_x = std::abs(b.x() - a.x()) > std::abs(b.y() - a.y());
  const bool is_forward = is_along_x ? b.x() > a.x() : b.y() > a.y();
  const std::size_t ahead = (is_along_x ? 0 : 1) + (is_forward ? 0 : 2);
  const double from_m = room_a.sides_m[ahead];
  const double to_m = room_b.sides_m[(ahead + 2) % 4];
  const Eigen::Vector2d way = (b - a).normalized();
  const Eigen::Vector2d across(-way.y() * kHalf_m, way.x() * kHalf_m);
  const Eigen::Vector2d begin = a + way * from_m;
  const Eigen::Vector2d end = b - way * to_m;
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector2d p = begin + side * across;
    const Eigen::Vector2d q = end + side * across;
    to.push_back({p.x(), p.y(), q.x(), q.y()});
  }
}

/// Poses 0.1 s apart along a way: half-way along each leg the robot stands for 1.5 s, and it drives
/// the first half slowly and the second fast or the other way around.
std::vector<Pose2> stop_and_go(const std::vector<Eigen::Vector2d>& way, std::mt19937_64& random) {
  std::vector<Pose2> poses;
  for (std::size_t leg = 1; leg < way.size(); ++leg) {
    const Eigen::Vector2d middle = 0.5 * (way[leg - 1] + way[leg]);
    const bool is_slow_first = random() % 2 == 0;
    const Eigen::Vector2d ends[] = {way[leg - 1], middle, way[leg]};
    for (int half = 0; half < 2; ++half) {
      const double step_m = (half == 0) == is_slow_first ? 0.07 : 0.13;
      std::vector<Pose2> driven = testing::drive({ends[half], ends[half + 1]}, step_m);
      if (!poses.empty()) {  // Turns on the spot from the last heading.
        const double from_rad = poses.back().theta_rad;
        const double turn_rad = wrap_to_pi(driven.back().theta_rad - from_rad);
        std::erase_if(driven, [&](const Pose2& pose) {
          return std::abs(wrap_to_pi(pose.theta_rad - driven.back().theta_rad)) > 1e-6;
        });
        const int num_turns = static_cast<int>(std::ceil(std::abs(turn_rad) / 0.05));
        for (int k = 0; k < num_turns; ++k) {
          Pose2 turned = driven.front();
          turned.theta_rad = wrap_to_pi(from_rad + turn_rad * k / num_turns);
          poses.push_back(turned);
        }
      }
      poses.insert(poses.end(), driven.begin(), driven.end());
      if (half == 0) poses.insert(poses.end(), 15, driven.back());
    }
  }
  return poses;
}

/// What a robot saw, and where it was.
struct Drive {
  Drive(const std::vector<Wall>& walls,
        const std::vector<Eigen::Vector2d>& way,
        std::mt19937_64& random)
      : truth(stop_and_go(way, random)), scans(testing::scans_on_drive(walls, truth, 0.01)) {
    for (Scan& scan : scans) {
      scan.max_range_m = kSight_m;
      for (double& range_m : scan.ranges_m) {
        if (range_m > kSight_m) range_m = std::numeric_limits<double>::infinity();
      }
    }
  }
  std::vector<Pose2> truth;
  std::vector<Scan> scans;
};

/// Four rooms at the corners of a ring, driven around once and to the third room again.
Drive ring(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> length_m(30.0, 36.0);
  const double x_m = length_m(random);
  const double y_m = length_m(random);
  const std::vector<Eigen::Vector2d> corners = {{0.0, 0.0}, {x_m, 0.0}, {x_m, y_m}, {0.0, y_m}};
  const unsigned doors[] = {kEast | kNorth, kWest | kNorth, kWest | kSouth, kEast | kSouth};
  std::vector<Room> rooms;
  for (std::size_t i = 0; i < 4; ++i) rooms.emplace_back(random);
  std::vector<Wall> walls;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    add_room(rooms[i], corners[i], doors[i], walls);
    add_corridor(corners[i], rooms[i], corners[next], rooms[next], walls);
  }
  std::vector<Eigen::Vector2d> way = corners;
  way.insert(way.end(), corners.begin(), corners.begin() + 3);
  return {walls, way, random};
}

/// Four rooms along a spiral outward and then an exact twin of the first, off by `off_m`.
Drive spiral(std::uint64_t seed, const Eigen::Vector2d& off_m) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> length_m(20.0, 30.0);
  const double x_m = length_m(random);
  const double y_m = length_m(random);
  const std::vector<Eigen::Vector2d> places = {{0.0, 0.0},
                                               {x_m, 0.0},
                                               {x_m, y_m},
                                               {-off_m.x(), y_m},
                                               -off_m,
                                               {12.0 - off_m.x(), -off_m.y()}};
  const unsigned doors[] = {kEast, kWest | kNorth, kWest | kSouth, kEast | kSouth, kEast, kWest};
  std::vector<Room> rooms;
  for (std::size_t i = 0; i < 4; ++i) rooms.emplace_back(random);
  rooms.push_back(rooms[0]);
  rooms.emplace_back(random);
  std::vector<Wall> walls;
  for (std::size_t i = 0; i < places.size(); ++i) {
    add_room(rooms[i], places[i], doors[i] | (i == 4 ? kNorth : 0U), walls);
    if (i > 0) add_corridor(places[i - 1], rooms[i - 1], places[i], rooms[i], walls);
  }
  return {walls, places, random};
}

Map map_of(const Drive& drive, const MapperParams& params) {
  Mapper mapper(params);
  for (const Scan& scan : drive.scans) mapper.add(scan);
  return mapper.finish();
}

/// How far off scans lie to each other that were taken from the same place a lap apart, at worst,
/// among those that tell where they are.
double worst_return_m(const Drive& drive, const Map& map) {
  constexpr std::size_t kApart = 600;
  double worst_m = 0.0;
  for (std::size_t j = kApart; j < drive.truth.size(); j += 5) {
    for (std::size_t i = 0; i + kApart < j; i += 5) {
      const Pose2 truth = testing::between(drive.truth[i], drive.truth[j]);
      if (truth.translation().norm() > 0.3 || std::abs(truth.theta_rad) > 0.1) continue;
      if (map.scans[i].status != TrackStatus::kTracked ||
          map.scans[j].status != TrackStatus::kTracked) {
        continue;
      }
      const Pose2 mapped = testing::between(map.scans[i].T_map_sensor, map.scans[j].T_map_sensor);
      worst_m = std::max(worst_m, (mapped.translation() - truth.translation()).norm());
    }
  }
  return worst_m;
}

TEST(MapperRings, LoopsThroughBareCorridorsAreClosedWhereverTheyLie) {
  MapperParams without;
  without.anywhere.is_on = false;
  std::size_t num_open = 0;
  for (std::uint64_t seed = 1; seed <= kNumSeeds; ++seed) {
    const Drive drive = ring(seed);
    EXPECT_LT(worst_return_m(drive, map_of(drive, {})), 0.3) << seed;
    num_open += worst_return_m(drive, map_of(drive, without)) > 3.0;
  }
  EXPECT_EQ(num_open, kNumSeeds) << "no loop is closed without the rule";
}

/// Accepted closures that bind both axes and are off by half a metre and more.
std::size_t num_wrong(const Drive& drive, const Map& map) {
  std::size_t num = 0;
  for (const MappedClosure& closure : map.closures) {
    if (!closure.closure.is_accepted || closure.closure.axes != ClosureAxes::kXY) continue;
    const Pose2 truth = testing::between(drive.truth[closure.scan_i], drive.truth[closure.scan_j]);
    num += (truth.translation() - closure.closure.T_i_j.translation()).norm() > 0.5;
  }
  return num;
}

TEST(MapperRings, ATwinOfTheFirstRoomIsNotTakenForIt) {
  for (std::uint64_t seed = 1; seed <= kNumSeeds; ++seed) {
    const Drive drive = spiral(seed, {9.0 + static_cast<double>(seed), 12.0});
    EXPECT_EQ(num_wrong(drive, map_of(drive, {})), 0U) << seed;
  }
}

TEST(MapperRings, ATwinIsTakenForTheFirstRoomWhereExtentsDoNotCount) {
  MapperParams params;
  params.anywhere.extent_share = 0.0;
  std::size_t num_taken = 0;
  for (std::uint64_t seed = 1; seed <= kNumSeeds; ++seed) {
    const Drive drive = spiral(seed, {9.0 + static_cast<double>(seed), 12.0});
    num_taken += num_wrong(drive, map_of(drive, params)) > 0;
  }
  EXPECT_GT(num_taken, 0U);
}

}  // namespace setsquare::mapper_rings_test
