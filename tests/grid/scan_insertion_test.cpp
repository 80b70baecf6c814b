// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/grid/scan_insertion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "setsquare/core/error.hpp"
#include "tests/support/rectangular_room.hpp"

namespace setsquare {
namespace {

/// One beam straight ahead.
Scan single_beam(double range_m) {
  Scan scan;
  scan.max_range_m = 50.0;
  scan.ranges_m = {range_m};
  return scan;
}

TEST(ScanInsertion, FreesTheBeamAndOccupiesItsEnd) {
  OccupancyGrid grid({}, 1.0, 10, 3);
  insert_scan(grid, {1.5, 1.5, 0.0}, single_beam(5.0));
  for (CellIndex cell; cell.row < 3; ++cell.row) {
    for (cell.column = 0; cell.column < 10; ++cell.column) {
      const bool is_on_beam = cell.row == 1 && cell.column >= 1 && cell.column < 6;
      const CellState expected = cell == CellIndex{6, 1} ? CellState::kOccupied
                                 : is_on_beam            ? CellState::kFree
                                                         : CellState::kUnknown;
      EXPECT_EQ(grid.state(cell), expected) << cell.column << ", " << cell.row;
    }
  }
}

TEST(ScanInsertion, NoReturnFreesALimitedRangeAndOccupiesNothing) {
  OccupancyGrid grid({}, 1.0, 20, 1);
  insert_scan(grid, {0.5, 0.5, 0.0}, single_beam(81.83), {.max_no_return_range_m = 4.0});
  for (std::int32_t column = 0; column < 20; ++column) {
    EXPECT_EQ(grid.state({column, 0}), column < 4 ? CellState::kFree : CellState::kUnknown);
  }
}

TEST(ScanInsertion, AReturnTooFarCountsAsNoReturn) {
  OccupancyGrid grid({}, 1.0, 20, 1);
  insert_scan(grid,
              {0.5, 0.5, 0.0},
              single_beam(12.0),
              {.max_return_range_m = 10.0, .max_no_return_range_m = 3.0});
  EXPECT_EQ(grid.state({2, 0}), CellState::kFree);
  EXPECT_EQ(grid.state({12, 0}), CellState::kUnknown);
}

TEST(ScanInsertion, InvalidBeamsTellNothing) {
  for (const double range_m : {std::nan(""), 0.0, -1.0, -std::numeric_limits<double>::infinity()}) {
    OccupancyGrid grid({}, 1.0, 20, 1);
    insert_scan(grid, {0.5, 0.5, 0.0}, single_beam(range_m));
    for (const float value : grid.values()) EXPECT_EQ(value, 0.0F) << range_m;
  }
}

TEST(ScanInsertion, WallSeenAtAGrazingAngleStays) {
  OccupancyGrid grid({-1.0, -1.0, 0.0}, 0.05, 640, 80);
  const Scan scan = testing::scan_of_room({1.0, 1.0, 0.0}, 30.0, 2.0, 3600);
  insert_scan(grid, {1.0, 1.0, 0.0}, scan, {.max_return_range_m = 100.0});
  for (const BeamEnd& end : beam_ends(scan, {.max_return_range_m = 100.0})) {
    const CellIndex cell{static_cast<std::int32_t>(std::floor((end.x_m + 2.0) / 0.05)),
                         static_cast<std::int32_t>(std::floor((end.y_m + 2.0) / 0.05))};
    if (grid.contains(cell)) {
      EXPECT_NE(grid.state(cell), CellState::kFree);
    }
  }
  EXPECT_EQ(grid.state({39, 39}), CellState::kFree);
}

TEST(ScanInsertion, StaysWithinItsBoundsAndForgetsNothingAtOnce) {
  const ScanInsertionParams params;
  OccupancyGrid grid({}, 1.0, 10, 1);
  for (int i = 0; i < 100; ++i) insert_scan(grid, {0.5, 0.5, 0.0}, single_beam(5.0), params);
  EXPECT_EQ(grid.log_odds({5, 0}), static_cast<float>(params.max_log_odds));
  EXPECT_EQ(grid.log_odds({2, 0}), static_cast<float>(params.min_log_odds));
  insert_scan(grid, {0.5, 0.5, 0.0}, single_beam(8.0), params);
  EXPECT_EQ(grid.state({5, 0}), CellState::kOccupied);
}

TEST(ScanInsertion, WhatLiesOutsideIsLeftOutAndChangesNothingInside) {
  const Scan scan = testing::scan_of_room({4.2, 3.1, 0.4}, 10.0, 8.0, 720);
  OccupancyGrid whole({-1.0, -1.0, 0.0}, 0.1, 120, 100);
  OccupancyGrid part({2.0, 2.0, 0.0}, 0.1, 20, 15);
  insert_scan(whole, {4.2, 3.1, 0.4}, scan);
  insert_scan(part, {4.2, 3.1, 0.4}, scan);
  for (CellIndex cell; cell.row < 15; ++cell.row) {
    for (cell.column = 0; cell.column < 20; ++cell.column) {
      EXPECT_EQ(part.log_odds(cell), whole.log_odds({cell.column + 30, cell.row + 30}));
    }
  }
}

TEST(ScanInsertion, AskewGridSeesTheSameWorld) {
  const Pose2 T_map_grid{-3.0, 2.0, 0.7};
  const Pose2 T_grid_sensor{4.2, 3.1, 0.4};
  const Scan scan = testing::scan_of_room(T_grid_sensor, 10.03, 8.03, 720);
  OccupancyGrid upright({}, 0.1, 120, 100);
  OccupancyGrid askew(T_map_grid, 0.1, 120, 100);
  insert_scan(upright, T_grid_sensor, scan);
  insert_scan(askew, T_map_grid * T_grid_sensor, scan);
  std::size_t num_different = 0;
  for (std::size_t i = 0; i < upright.values().size(); ++i) {
    if (upright.values()[i] != askew.values()[i]) ++num_different;
  }
  EXPECT_LE(num_different, upright.values().size() / 200);
}

TEST(ScanInsertionParams, NamesTheBadField) {
  try {
    ScanInsertionParams{.pass_log_odds = 0.1}.validate();
    FAIL() << "no exception";
  } catch (const ParameterError& error) {
    EXPECT_NE(std::string(error.what()).find("pass_log_odds"), std::string::npos);
  }
}

}  // namespace
}  // namespace setsquare
