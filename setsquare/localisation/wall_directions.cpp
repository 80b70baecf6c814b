// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/wall_directions.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Core>

#include "setsquare/surfaces/surface_points.hpp"

namespace setsquare {
namespace {

constexpr double kFitRadius_m = 0.5;
/// The scatter across a line is at most this share of the scatter along it.
constexpr double kMaxThickness = 0.15;

bool borders_on_free(const WallDistance& walls, CellIndex cell) {
  for (const CellIndex beside : {CellIndex{cell.column - 1, cell.row},
                                 CellIndex{cell.column + 1, cell.row},
                                 CellIndex{cell.column, cell.row - 1},
                                 CellIndex{cell.column, cell.row + 1}}) {
    if (walls.state(beside) == CellState::kFree) return true;
  }
  return false;
}

}  // namespace

AngleHistogram wall_directions(const WallDistance& walls) {
  SurfacePoints faces;
  const double cell_m = walls.resolution_m();
  const auto radius = static_cast<std::int32_t>(std::max(2.0, std::round(kFitRadius_m / cell_m)));
  const auto add = [&](double normal_x, double normal_y) {
    faces.x_m.push_back(0.0F);
    faces.y_m.push_back(0.0F);
    faces.normal_x.push_back(static_cast<float>(normal_x));
    faces.normal_y.push_back(static_cast<float>(normal_y));
    faces.weight_m.push_back(static_cast<float>(cell_m));
  };
  for (std::int32_t row = 0; row < walls.num_rows(); ++row) {
    for (std::int32_t column = 0; column < walls.num_columns(); ++column) {
      const CellIndex cell{column, row};
      if (walls.state(cell) != CellState::kOccupied || !borders_on_free(walls, cell)) continue;
      double count = 0.0;
      double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
      for (std::int32_t dy = -radius; dy <= radius; ++dy) {
        for (std::int32_t dx = -radius; dx <= radius; ++dx) {
          if (walls.state({column + dx, row + dy}) != CellState::kOccupied) continue;
          count += 1.0;
          x += dx;
          y += dy;
          xx += dx * dx;
          xy += dx * dy;
          yy += dy * dy;
        }
      }
      if (count < 4.0) continue;
      xx -= x * x / count;
      xy -= x * y / count;
      yy -= y * y / count;
      const double along_rad = 0.5 * std::atan2(2.0 * xy, xx - yy);
      const double spread = std::hypot(0.5 * (xx - yy), xy);
      const double middle = 0.5 * (xx + yy);
      if (middle - spread > kMaxThickness * (middle + spread)) continue;
      const double normal_x = -std::sin(along_rad);
      const double normal_y = std::cos(along_rad);
      for (const double side : {-1.0, 1.0}) {
        for (const double away : {1.5, 2.5, 3.5}) {
          const CellIndex beyond{
              column + static_cast<std::int32_t>(std::lround(side * away * normal_x)),
              row + static_cast<std::int32_t>(std::lround(side * away * normal_y))};
          if (walls.state(beyond) != CellState::kFree) continue;
          add(side * normal_x, side * normal_y);
          break;
        }
      }
    }
  }
  return angle_histogram(faces);
}

}  // namespace setsquare
