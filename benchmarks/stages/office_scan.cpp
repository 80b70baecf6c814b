// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/stages/office_scan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace setsquare::benchmarks {
namespace {

constexpr double kMaxRange_m = 30.0;

/// A wall from (x1, y1) to (x2, y2), in m.
struct Wall {
  double x1_m, y1_m, x2_m, y2_m;
};

constexpr std::array<Wall, 18> kWalls = {{
    // The room, with its door open to the corridor.
    {0.0, 0.0, 12.0, 0.0},
    {12.0, 0.0, 12.0, 4.0},
    {12.0, 5.0, 12.0, 9.0},
    {12.0, 9.0, 0.0, 9.0},
    {0.0, 9.0, 0.0, 0.0},
    {12.0, 4.0, 25.0, 4.0},
    {12.0, 5.0, 25.0, 5.0},
    // Two desks.
    {7.0, 1.0, 9.0, 1.0},
    {9.0, 1.0, 9.0, 2.0},
    {9.0, 2.0, 7.0, 2.0},
    {7.0, 2.0, 7.0, 1.0},
    {6.0, 7.0, 8.0, 7.0},
    {8.0, 7.0, 8.0, 8.0},
    {8.0, 8.0, 6.0, 8.0},
    {6.0, 8.0, 6.0, 7.0},
    // An oblique board, and two pilasters.
    {1.0, 6.0, 2.5, 7.5},
    {10.5, 0.0, 10.5, 0.4},
    {0.0, 4.5, 0.4, 4.5},
}};
constexpr double kColumnX_m = 9.5;
constexpr double kColumnY_m = 5.5;
constexpr double kColumnRadius_m = 0.3;

/// Distance along the ray to a wall; kMaxRange_m where it passes.
double range_to_wall(const Pose2& ray, const Wall& wall) {
  const double ray_x = std::cos(ray.theta_rad);
  const double ray_y = std::sin(ray.theta_rad);
  const double wall_x_m = wall.x2_m - wall.x1_m;
  const double wall_y_m = wall.y2_m - wall.y1_m;
  const double determinant_m = ray_x * wall_y_m - ray_y * wall_x_m;
  if (std::abs(determinant_m) < 1e-9) return kMaxRange_m;
  const double dx_m = wall.x1_m - ray.x_m;
  const double dy_m = wall.y1_m - ray.y_m;
  const double range_m = (dx_m * wall_y_m - dy_m * wall_x_m) / determinant_m;
  const double along = (dx_m * ray_y - dy_m * ray_x) / determinant_m;
  const bool is_hit = range_m > 0.0 && along >= 0.0 && along <= 1.0;
  return is_hit ? range_m : kMaxRange_m;
}

/// Distance along the ray to the column; kMaxRange_m where it passes.
double range_to_column(const Pose2& ray) {
  const double dx_m = kColumnX_m - ray.x_m;
  const double dy_m = kColumnY_m - ray.y_m;
  const double nearest_m = dx_m * std::cos(ray.theta_rad) + dy_m * std::sin(ray.theta_rad);
  const double miss_squared_m2 = dx_m * dx_m + dy_m * dy_m - nearest_m * nearest_m;
  const double half_chord_squared_m2 = kColumnRadius_m * kColumnRadius_m - miss_squared_m2;
  if (nearest_m <= 0.0 || half_chord_squared_m2 < 0.0) return kMaxRange_m;
  return nearest_m - std::sqrt(half_chord_squared_m2);
}

}  // namespace

Scan office_scan(const Pose2& T_map_sensor, std::size_t num_beams) {
  std::mt19937_64 generator(num_beams);
  std::normal_distribution<double> noise_m(0.0, 0.01);
  Scan scan;
  scan.first_bearing_rad = -0.5 * kPi;
  scan.bearing_step_rad = kPi / static_cast<double>(num_beams - 1);
  scan.max_range_m = kMaxRange_m;
  for (std::size_t beam = 0; beam < num_beams; ++beam) {
    Pose2 ray = T_map_sensor;
    ray.theta_rad += scan.first_bearing_rad + static_cast<double>(beam) * scan.bearing_step_rad;
    double range_m = range_to_column(ray);
    for (const Wall& wall : kWalls) range_m = std::min(range_m, range_to_wall(ray, wall));
    scan.ranges_m.push_back(range_m < kMaxRange_m ? range_m + noise_m(generator) : kMaxRange_m);
  }
  return scan;
}

}  // namespace setsquare::benchmarks
