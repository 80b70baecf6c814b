// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare::testing {

/// A straight wall between two points of the world, in m.
struct Wall {
  double x1_m, y1_m, x2_m, y2_m;
};

/// The shape of a sensor's fan.
struct Fan {
  std::size_t num_beams = 180;
  double first_bearing_rad = -0.5 * kPi;
  double bearing_step_rad = kPi / 180.0;
};

/// An L-shaped room with two cabinets, of which no half or quarter turn looks like itself.
inline std::vector<Wall> l_shaped_room() {
  return {{0.0, 0.0, 8.0, 0.0},
          {8.0, 0.0, 8.0, 5.0},
          {8.0, 5.0, 3.5, 5.0},
          {3.5, 5.0, 3.5, 9.0},
          {3.5, 9.0, 0.0, 9.0},
          {0.0, 9.0, 0.0, 0.0},
          {6.2, 0.0, 6.2, 1.3},
          {6.2, 1.3, 8.0, 1.3},
          {0.0, 6.1, 0.9, 6.1},
          {0.9, 6.1, 0.9, 7.0},
          {0.9, 7.0, 0.0, 7.0}};
}

/// Range of a ray to the nearest wall, infinite where it meets none.
inline double cast_ray(const std::vector<Wall>& walls, double x_m, double y_m, double angle_rad) {
  const double dx = std::cos(angle_rad);
  const double dy = std::sin(angle_rad);
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Wall& wall : walls) {
    const double wall_x = wall.x2_m - wall.x1_m;
    const double wall_y = wall.y2_m - wall.y1_m;
    const double determinant = wall_x * dy - wall_y * dx;
    if (std::abs(determinant) < 1e-12) continue;
    const double to_x = wall.x1_m - x_m;
    const double to_y = wall.y1_m - y_m;
    const double range_m = (wall_x * to_y - wall_y * to_x) / determinant;
    const double share = (dx * to_y - dy * to_x) / determinant;
    if (range_m > 1e-9 && share >= 0.0 && share <= 1.0) nearest_m = std::min(nearest_m, range_m);
  }
  return nearest_m;
}

/// The scan of the walls from a pose, its ranges with normal noise; a share of the beams drops out:
/// half of these give 0, half the code of a no-return.
inline Scan scan_of_walls(const std::vector<Wall>& walls,
                          const Pose2& T_world_sensor,
                          const Fan& fan = {},
                          double noise_m = 0.0,
                          std::uint64_t seed = 1,
                          double dropout_share = 0.0) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> noise(0.0, 1.0);
  Scan scan;
  scan.first_bearing_rad = fan.first_bearing_rad;
  scan.bearing_step_rad = fan.bearing_step_rad;
  scan.max_range_m = 30.0;
  for (std::size_t beam = 0; beam < fan.num_beams; ++beam) {
    const double bearing_rad =
        fan.first_bearing_rad + static_cast<double>(beam) * fan.bearing_step_rad;
    const double range_m = cast_ray(
        walls, T_world_sensor.x_m, T_world_sensor.y_m, T_world_sensor.theta_rad + bearing_rad);
    scan.ranges_m.push_back(range_m + noise_m * noise(generator));
    if (dropout_share <= 0.0) continue;
    const double lot = std::uniform_real_distribution<double>(0.0, 1.0)(generator);
    if (lot < dropout_share) scan.ranges_m.back() = lot < 0.5 * dropout_share ? 0.0 : 81.83;
  }
  return scan;
}

}  // namespace setsquare::testing
