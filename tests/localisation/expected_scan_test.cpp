// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/expected_scan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "setsquare/core/angle.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::expected_scan_test {

/// A room of free cells with posts in it, closed by a wall of one cell, in unknown space.
OccupancyGrid room_with_posts(std::mt19937_64& generator) {
  OccupancyGrid grid({}, 0.05, 160, 120);
  std::uniform_real_distribution<double> chance(0.0, 1.0);
  for (std::int32_t row = 10; row < 110; ++row) {
    for (std::int32_t column = 10; column < 150; ++column) {
      const bool is_border = row == 10 || row == 109 || column == 10 || column == 149;
      grid.values()[grid.index({column, row})] =
          is_border || chance(generator) < 0.003 ? 2.0F : -1.0F;
    }
  }
  return grid;
}

Eigen::Vector2d at_bearing(double bearing_rad) { return rotation_matrix(bearing_rad).col(0); }

/// Where the ray enters the first wall cell on it, by looking at every cell of the grid: between
/// the lines through its sides, in x and in y.
double plain_range_m(const OccupancyGrid& grid,
                     const WallDistance& walls,
                     double x_m,
                     double y_m,
                     double bearing_rad) {
  const double cell_m = grid.resolution_m();
  double nearest_m = 30.0;
  for (std::int32_t row = 0; row < 120; ++row) {
    for (std::int32_t column = 0; column < 160; ++column) {
      if (walls.state({column, row}) != CellState::kOccupied) continue;
      const auto [from_x, to_x] =
          std::minmax({(column * cell_m - x_m) / std::cos(bearing_rad),
                       ((column + 1) * cell_m - x_m) / std::cos(bearing_rad)});
      const auto [from_y, to_y] = std::minmax({(row * cell_m - y_m) / std::sin(bearing_rad),
                                               ((row + 1) * cell_m - y_m) / std::sin(bearing_rad)});
      const double enters_m = std::max({from_x, from_y, 0.0});
      if (enters_m < std::min(to_x, to_y)) nearest_m = std::min(nearest_m, enters_m);
    }
  }
  return nearest_m;
}

TEST(RangeToWall, EndsInTheFirstWallCellOnTheRay) {
  auto generator = testing::make_generator();
  std::uniform_real_distribution<double> x(0.6, 7.4);
  std::uniform_real_distribution<double> y(0.6, 5.4);
  std::uniform_real_distribution<double> bearing(-kPi, kPi);
  for (int trial = 0; trial < 10; ++trial) {
    const OccupancyGrid grid = room_with_posts(generator);
    const WallDistance walls(grid);
    for (int k = 0; k < 100; ++k) {
      const double x_m = x(generator);
      const double y_m = y(generator);
      const double bearing_rad = bearing(generator);
      const double enters_m = plain_range_m(grid, walls, x_m, y_m, bearing_rad);
      const double range_m = range_to_wall(walls, x_m, y_m, at_bearing(bearing_rad), 30.0);
      // Somewhere between where the ray enters the cell and the cell's diagonal.
      EXPECT_GE(range_m, enters_m - 0.001);
      EXPECT_LE(range_m, enters_m + 0.0708);
    }
  }
}

TEST(RangeToWall, IsOpenWhereNothingIsMetAndUnknownWhereTheMapKnowsNothing) {
  OccupancyGrid grid({}, 0.05, 400, 40);
  for (std::int32_t row = 0; row < 40; ++row) {
    for (std::int32_t column = 0; column < 300; ++column) {
      grid.values()[grid.index({column, row})] = -1.0F;
    }
  }
  const WallDistance walls(grid);
  EXPECT_TRUE(std::isinf(range_to_wall(walls, 1.0, 1.0, at_bearing(0.0), 10.0)));
  EXPECT_TRUE(std::isnan(range_to_wall(walls, 1.0, 1.0, at_bearing(0.0), 30.0)));
  EXPECT_TRUE(std::isnan(range_to_wall(walls, 1.0, 1.0, at_bearing(kPi), 30.0)));
  EXPECT_TRUE(std::isnan(range_to_wall(walls, -5.0, 1.0, at_bearing(0.0), 30.0)));
}

TEST(RangeToWall, PassesTheUnknownMetreAboutTheSensorAndNoMore) {
  // Free from 2 m on, a wall at 5 m; nothing is known before but a wall along the ray.
  OccupancyGrid grid({}, 0.05, 120, 40);
  for (std::int32_t row = 0; row < 40; ++row) {
    for (std::int32_t column = 40; column < 100; ++column) {
      grid.values()[grid.index({column, row})] = -1.0F;
    }
    grid.values()[grid.index({100, row})] = 2.0F;
  }
  for (std::int32_t column = 0; column < 100; ++column) {
    grid.values()[grid.index({column, 23})] = 2.0F;
  }
  const WallDistance walls(grid);
  EXPECT_NEAR(range_to_wall(walls, 1.2, 1.0, at_bearing(0.0), 10.0), 3.8, 0.051);
  EXPECT_TRUE(std::isnan(range_to_wall(walls, 0.8, 1.0, at_bearing(0.0), 10.0)));
}

TEST(LayoutOf, KeepsTheSweepAndIsNoDenserThanHalfADegree) {
  Scan scan;
  scan.first_bearing_rad = rad_from_deg(135.0);
  scan.bearing_step_rad = -rad_from_deg(0.25);
  scan.ranges_m.assign(1081, 1.0);
  const BeamLayout layout = layout_of(scan);
  EXPECT_EQ(layout.num_beams, 541U);
  EXPECT_NEAR(layout.first_bearing_rad +
                  static_cast<double>(layout.num_beams - 1) * layout.bearing_step_rad,
              rad_from_deg(-135.0),
              1e-9);
  scan.bearing_step_rad = rad_from_deg(1.0);
  scan.ranges_m.resize(181);
  EXPECT_EQ(layout_of(scan).num_beams, 181U);
}

}  // namespace setsquare::expected_scan_test
