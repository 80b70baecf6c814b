// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/rooms.hpp"

#include <algorithm>
#include <cmath>

#include "tests/support/seed.hpp"

namespace setsquare::testing {
namespace {

/// A box about a pose; closed, so that nothing looks into it.
std::vector<Wall> box(const Pose2& middle, double length_m, double depth_m) {
  std::vector<Eigen::Vector2d> corners_m;
  for (const auto& [x, y] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
    corners_m.push_back(middle * Eigen::Vector2d(x * length_m, y * depth_m));
  }
  return closed_polygon(corners_m);
}

void append(const std::vector<Wall>& more, std::vector<Wall>& walls) {
  walls.insert(walls.end(), more.begin(), more.end());
}

std::vector<Eigen::Vector2d> points_of(const Scan& scan) {
  std::vector<Eigen::Vector2d> points_m;
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    const double range_m = scan.ranges_m[beam];
    if (!(range_m > 0.0 && range_m < scan.max_range_m)) continue;
    const double bearing_rad = scan.bearing_rad(beam);
    points_m.emplace_back(range_m * std::cos(bearing_rad), range_m * std::sin(bearing_rad));
  }
  return points_m;
}

constexpr std::size_t kNumRoomWalls = 8;
constexpr std::size_t kNumBoxWalls = 4;

/// A ray out of a closed box crosses its walls an odd number of times.
bool is_inside_furniture(const FurnishedRoom& room, const Pose2& pose) {
  constexpr double kAnyAngle_rad = 0.123;
  for (std::size_t i = kNumRoomWalls; i < room.walls.size(); i += kNumBoxWalls) {
    int num_crossed = 0;
    for (std::size_t k = i; k < i + kNumBoxWalls; ++k) {
      num_crossed += std::isfinite(cast_ray({room.walls[k]}, pose.x_m, pose.y_m, kAnyAngle_rad));
    }
    if (num_crossed % 2 == 1) return true;
  }
  return false;
}

}  // namespace

std::vector<Wall> closed_polygon(const std::vector<Eigen::Vector2d>& corners_m) {
  std::vector<Wall> walls;
  for (std::size_t i = 0; i < corners_m.size(); ++i) {
    const Eigen::Vector2d& a = corners_m[i];
    const Eigen::Vector2d& b = corners_m[(i + 1) % corners_m.size()];
    walls.push_back({a.x(), a.y(), b.x(), b.y()});
  }
  return walls;
}

std::vector<Wall> regular_polygon(int num_corners, double radius_m) {
  std::vector<Eigen::Vector2d> corners_m;
  for (int i = 0; i < num_corners; ++i) {
    const double bearing_rad = kTwoPi * i / num_corners;
    corners_m.emplace_back(radius_m * std::cos(bearing_rad), radius_m * std::sin(bearing_rad));
  }
  return closed_polygon(corners_m);
}

std::vector<Wall> empty_rectangle(double width_m, double height_m) {
  return closed_polygon({{0, 0}, {width_m, 0}, {width_m, height_m}, {0, height_m}});
}

std::vector<Wall> endless_corridor() { return {{-90, 0.0, 90, 0.0}, {-90, 2.4, 90, 2.4}}; }

std::vector<Wall> oblique_room() {
  std::vector<Wall> walls =
      closed_polygon({{0, 0}, {6, 0}, {8.5, 4.33}, {6.0, 5.77}, {4.0, 2.8}, {0, 2.8}});
  append(box({5.2, 0.5, 0.3}, 0.9, 0.6), walls);
  append(box({1.0, 2.4, 0.0}, 1.4, 0.5), walls);
  return walls;
}

std::vector<Wall> irregular_room() {
  std::vector<Wall> walls = closed_polygon(
      {{0, 0}, {4.1, -0.7}, {7.3, 1.2}, {6.8, 4.9}, {3.9, 6.6}, {1.2, 5.1}, {-1, 3}});
  append(box({5.4, 3.9, 0.5}, 1.1, 0.5), walls);
  walls.push_back({0.4, 2.9, 1.0, 3.7});
  walls.push_back({3.4, 0.3, 4.0, 0.5});
  return walls;
}

FurnishedRoom furnished_room(std::mt19937_64& generator) {
  FurnishedRoom room;
  const double width_m = room.width_m = uniform(generator, 6.0, 9.0);
  const double height_m = room.height_m = uniform(generator, 5.0, 8.0);
  const double niche_m = uniform(generator, 0.8, width_m - 2.5);
  room.walls = closed_polygon({{0, 0},
                               {niche_m, 0},
                               {niche_m, -0.6},
                               {niche_m + 1.3, -0.6},
                               {niche_m + 1.3, 0},
                               {width_m, 0},
                               {width_m, height_m},
                               {0, height_m}});
  for (int i = 0; i < 6; ++i) {
    const bool is_askew = i >= 4;
    const Pose2 middle{uniform(generator, 0.0, width_m),
                       uniform(generator, 0.0, height_m),
                       is_askew ? uniform(generator, -kPi, kPi) : 0.0};
    append(box(middle, uniform(generator, 0.4, 1.6), uniform(generator, 0.3, 0.8)), room.walls);
  }
  return room;
}

std::vector<Wall> end_of_a_corridor(std::mt19937_64& generator) {
  const double width_m = uniform(generator, 2.3, 2.7);
  const double length_m = uniform(generator, 9.0, 13.0);
  const double hall_m = length_m + 6.0;
  std::vector<Wall> walls{{0.0, 0.0, 0.0, width_m}, {hall_m, -6.0, hall_m, width_m + 6.0}};
  for (const double outward : {-1.0, 1.0}) {
    const double slope = uniform(generator, -0.005, 0.005);
    const auto at = [&](double x_m) { return (outward > 0.0 ? width_m : 0.0) + slope * x_m; };
    double x_m = 0.0;
    while (true) {
      const double door_m = x_m + uniform(generator, 1.5, 5.0);
      const double end_m = door_m + uniform(generator, 0.8, 1.2);
      const double depth_m = outward * uniform(generator, 0.1, 0.5);
      if (end_m > length_m - 0.5) break;
      walls.push_back({x_m, at(x_m), door_m, at(door_m)});
      walls.push_back({door_m, at(door_m), door_m, at(door_m) + depth_m});
      walls.push_back({door_m, at(door_m) + depth_m, end_m, at(end_m) + depth_m});
      walls.push_back({end_m, at(end_m) + depth_m, end_m, at(end_m)});
      x_m = end_m;
    }
    const double out_m = at(0.0) + outward * uniform(generator, 2.0, 5.0);
    walls.push_back({x_m, at(x_m), length_m, at(length_m)});
    walls.push_back({length_m, at(length_m), length_m, out_m});
    walls.push_back({length_m, out_m, hall_m, out_m});
  }
  return walls;
}

Pose2 pose_before_the_end(std::mt19937_64& generator) {
  const double x_m = uniform(generator, 3.0, 9.0);
  const double y_m = uniform(generator, 0.8, 1.6);
  return {x_m, y_m, kPi + uniform(generator, -0.6, 0.6)};
}

Pose2 free_pose(const FurnishedRoom& room, std::mt19937_64& generator) {
  constexpr double kClearance_m = 0.4;
  while (true) {
    const Pose2 pose{uniform(generator, 0.5, room.width_m - 0.5),
                     uniform(generator, 0.5, room.height_m - 0.5),
                     uniform(generator, -kPi, kPi)};
    double nearest_m = kClearance_m + 1.0;
    for (int i = 0; i < 72; ++i) {
      nearest_m = std::min(nearest_m, cast_ray(room.walls, pose.x_m, pose.y_m, kTwoPi * i / 72));
    }
    if (nearest_m > kClearance_m && !is_inside_furniture(room, pose)) return pose;
  }
}

double true_overlap(const Scan& reference, const Scan& current, const Pose2& T_reference_current) {
  const auto reference_m = points_of(reference);
  const auto current_m = points_of(current);
  if (current_m.empty()) return 0.0;
  const auto is_seen = [&](const Eigen::Vector2d& p_current) {
    const Eigen::Vector2d p_reference = T_reference_current * p_current;
    return std::any_of(reference_m.begin(), reference_m.end(), [&](const Eigen::Vector2d& q) {
      return (q - p_reference).squaredNorm() < 0.04;
    });
  };
  const auto num_seen = std::count_if(current_m.begin(), current_m.end(), is_seen);
  return static_cast<double>(num_seen) / static_cast<double>(current_m.size());
}

}  // namespace setsquare::testing
