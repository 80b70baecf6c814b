// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/expected_scan.hpp"

#include <gtest/gtest.h>

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

/// The first wall cell met in steps of a hundredth of a cell.
double plain_range_m(const WallDistance& walls, double x_m, double y_m, double bearing_rad) {
  for (double range_m = 0.0; range_m < 30.0; range_m += 0.0005) {
    const CellIndex cell =
        walls.cell_at(x_m + range_m * std::cos(bearing_rad), y_m + range_m * std::sin(bearing_rad));
    if (walls.state(cell) == CellState::kOccupied) return range_m;
  }
  return 30.0;
}

TEST(RangeToWall, EndsInTheFirstWallCellOnTheRay) {
  auto generator = testing::make_generator();
  std::uniform_real_distribution<double> x(0.6, 7.4);
  std::uniform_real_distribution<double> y(0.6, 5.4);
  std::uniform_real_distribution<double> bearing(-kPi, kPi);
  for (int trial = 0; trial < 10; ++trial) {
    const WallDistance walls(room_with_posts(generator));
    for (int k = 0; k < 100; ++k) {
      const double x_m = x(generator);
      const double y_m = y(generator);
      const double bearing_rad = bearing(generator);
      const double enters_m = plain_range_m(walls, x_m, y_m, bearing_rad);
      const double range_m = range_to_wall(walls, x_m, y_m, bearing_rad, 30.0);
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
  EXPECT_TRUE(std::isinf(range_to_wall(walls, 1.0, 1.0, 0.0, 10.0)));
  EXPECT_TRUE(std::isnan(range_to_wall(walls, 1.0, 1.0, 0.0, 30.0)));
  EXPECT_TRUE(std::isnan(range_to_wall(walls, 1.0, 1.0, kPi, 30.0)));
  EXPECT_TRUE(std::isnan(range_to_wall(walls, -5.0, 1.0, 0.0, 30.0)));
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
  EXPECT_NEAR(range_to_wall(walls, 1.2, 1.0, 0.0, 10.0), 3.8, 0.051);
  EXPECT_TRUE(std::isnan(range_to_wall(walls, 0.8, 1.0, 0.0, 10.0)));
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
