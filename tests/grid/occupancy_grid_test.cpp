// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/grid/occupancy_grid.hpp"

#include <gtest/gtest.h>

#include "setsquare/core/error.hpp"

namespace setsquare::occupancy_grid_test {

TEST(OccupancyGrid, StartsUnknown) {
  const OccupancyGrid grid({1.0, 2.0, 0.3}, 0.05, 4, 3);
  EXPECT_EQ(grid.values().size(), 12U);
  EXPECT_EQ(grid.T_map_grid(), (Pose2{1.0, 2.0, 0.3}));
  for (CellIndex cell; cell.row < 3; ++cell.row) {
    for (cell.column = 0; cell.column < 4; ++cell.column) {
      EXPECT_EQ(grid.state(cell), CellState::kUnknown);
      EXPECT_EQ(grid.probability(cell), 0.5);
    }
  }
}

TEST(OccupancyGrid, StateAndProbabilityFollowTheLogOdds) {
  OccupancyGrid grid({}, 1.0, 2, 2);
  grid.values()[grid.index({1, 0})] = 1.0986123F;  // ln 3
  grid.values()[grid.index({0, 1})] = -1.0986123F;
  EXPECT_EQ(grid.state({1, 0}), CellState::kOccupied);
  EXPECT_EQ(grid.state({0, 1}), CellState::kFree);
  EXPECT_NEAR(grid.probability({1, 0}), 0.75, 1e-7);
  EXPECT_NEAR(grid.probability({0, 1}), 0.25, 1e-7);
}

TEST(OccupancyGrid, ContainsItsCellsOnly) {
  const OccupancyGrid grid({}, 1.0, 2, 3);
  EXPECT_TRUE(grid.contains({0, 0}));
  EXPECT_TRUE(grid.contains({1, 2}));
  EXPECT_FALSE(grid.contains({2, 0}));
  EXPECT_FALSE(grid.contains({0, 3}));
  EXPECT_FALSE(grid.contains({-1, 0}));
  EXPECT_FALSE(grid.contains({0, -1}));
}

TEST(OccupancyGrid, RefusesImpossibleSizes) {
  EXPECT_THROW(OccupancyGrid({}, 0.0, 1, 1), ParameterError);
  EXPECT_THROW(OccupancyGrid({}, 0.1, 0, 1), ParameterError);
  EXPECT_THROW(OccupancyGrid({}, 0.1, 1, -5), ParameterError);
  EXPECT_THROW(OccupancyGrid({}, 0.1, 2'000'000'000, 2'000'000'000), ParameterError);
}

}  // namespace setsquare::occupancy_grid_test
