// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/wall_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/seed.hpp"

namespace setsquare::wall_distance_test {

/// Walls here and there, free space, and cells of which nothing is known.
OccupancyGrid random_grid(std::mt19937_64& generator, double resolution_m) {
  std::uniform_int_distribution<int> side(1, 40);
  OccupancyGrid grid({}, resolution_m, side(generator), side(generator));
  std::uniform_real_distribution<double> chance(0.0, 1.0);
  const double wall_share = 0.1 * chance(generator);
  for (float& value : grid.values()) {
    const double fate = chance(generator);
    value = fate < wall_share ? 2.0F : (fate < 0.7 ? -1.0F : 0.0F);
  }
  return grid;
}

double plain_distance_m(const OccupancyGrid& grid, CellIndex from) {
  double nearest_m = WallDistance::kReach_m;
  for (std::int32_t row = 0; row < grid.num_rows(); ++row) {
    for (std::int32_t column = 0; column < grid.num_columns(); ++column) {
      if (grid.state({column, row}) != CellState::kOccupied) continue;
      nearest_m = std::min(nearest_m,
                           grid.resolution_m() * std::hypot(column - from.column, row - from.row));
    }
  }
  return nearest_m;
}

TEST(WallDistance, IsThatOfThePlainSearchOverAllCells) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 40; ++trial) {
    const OccupancyGrid grid = random_grid(generator, trial % 2 == 0 ? 0.05 : 0.21);
    const WallDistance walls(grid);
    for (std::int32_t row = 0; row < grid.num_rows(); ++row) {
      for (std::int32_t column = 0; column < grid.num_columns(); ++column) {
        ASSERT_NEAR(walls.distance_m({column, row}), plain_distance_m(grid, {column, row}), 0.0051)
            << column << ", " << row << " of trial " << trial;
        ASSERT_EQ(walls.state({column, row}), grid.state({column, row}));
      }
    }
  }
}

TEST(WallDistance, SlopeIsThatOfTheDistancesAroundThePlace) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 20; ++trial) {
    const OccupancyGrid grid = random_grid(generator, 0.05);
    const WallDistance walls(grid);
    std::uniform_real_distribution<double> x(0.0, grid.num_columns() * 0.05);
    std::uniform_real_distribution<double> y(0.0, grid.num_rows() * 0.05);
    for (int k = 0; k < 50; ++k) {
      // A step inside one square of four cells' middles: the distance is bilinear there.
      const double column = std::floor(x(generator) / 0.05 - 0.5) + 0.5;
      const double row = std::floor(y(generator) / 0.05 - 0.5) + 0.5;
      const auto at = [&](double u, double v) {
        return walls.slope_at(static_cast<float>((column + u) * 0.05),
                              static_cast<float>((row + v) * 0.05));
      };
      const auto middle = at(0.5, 0.5);
      EXPECT_NEAR((at(0.7, 0.5).distance_m - at(0.3, 0.5).distance_m) / 0.02, middle.along_x, 2e-3);
      EXPECT_NEAR((at(0.5, 0.7).distance_m - at(0.5, 0.3).distance_m) / 0.02, middle.along_y, 2e-3);
    }
  }
}

TEST(WallDistance, OutsideTheGridNothingIsKnown) {
  OccupancyGrid grid({}, 0.05, 3, 3);
  for (float& value : grid.values()) value = 1.0F;
  const WallDistance walls(grid);
  EXPECT_EQ(walls.state({-1, 0}), CellState::kUnknown);
  EXPECT_EQ(walls.state({0, 3}), CellState::kUnknown);
  EXPECT_EQ(walls.slope_at(1.0F, 1.0F).distance_m, static_cast<float>(WallDistance::kReach_m));
  EXPECT_EQ(walls.state(walls.cell_at(1e300, -1e300)), CellState::kUnknown);
}

}  // namespace setsquare::wall_distance_test
