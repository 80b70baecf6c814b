// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/grid/scan_insertion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "setsquare/core/error.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::scan_insertion_test {

/// A separate grid with one band that holds all its rows.
struct CountedGrid {
  CountedGrid(double resolution_m, std::int32_t num_columns, std::int32_t num_rows)
      : grid({}, resolution_m, num_columns, num_rows),
        num_hits(grid.values().size(), 0),
        band(0, num_columns, grid.values(), num_hits) {}

  void count(const Pose2& T_grid_sensor, const std::vector<BeamEnd>& ends) {
    band.count(T_grid_sensor, grid.resolution_m(), ends, params);
  }
  const OccupancyGrid& finish() {
    band.finish(params);
    return grid;
  }

  OccupancyGrid grid;
  std::vector<std::uint16_t> num_hits;
  EvidenceBand band;
  ScanInsertionParams params;
};

BeamEnd hit_at(double x_m, double y_m = 0.0) { return {x_m, y_m, true, false}; }
BeamEnd free_to(double x_m) { return {x_m, 0.0, false, false}; }

TEST(ScanInsertion, FreesTheBeamAndOccupiesItsEnd) {
  CountedGrid counted(1.0, 10, 3);
  counted.count({1.5, 1.5, 0.0}, {hit_at(5.0)});
  const OccupancyGrid& grid = counted.finish();
  for (CellIndex cell; cell.row < 3; ++cell.row) {
    for (cell.column = 0; cell.column < 10; ++cell.column) {
      const bool is_on_beam = cell.row == 1 && cell.column >= 1 && cell.column < 6;
      const double expected = cell == CellIndex{6, 1} ? counted.params.hit_log_odds
                              : is_on_beam            ? counted.params.pass_log_odds
                                                      : 0.0;
      EXPECT_NEAR(grid.log_odds(cell), expected, 1e-6) << cell.column << ", " << cell.row;
    }
  }
}

TEST(ScanInsertion, NoReturnsWeighLessAndOccupyNothing) {
  CountedGrid counted(1.0, 10, 1);
  counted.count({0.5, 0.5, 0.0}, {free_to(4.0)});
  const OccupancyGrid& grid = counted.finish();
  const double one = counted.params.pass_log_odds / counted.params.no_returns_per_pass;
  for (std::int32_t column = 0; column < 10; ++column) {
    EXPECT_NEAR(grid.log_odds({column, 0}), column < 4 ? one : 0.0, 1e-6);
  }
}

TEST(ScanInsertion, WallSeenAtAGrazingAngleIsNotFreedBetweenItsReturns) {
  // A slanting wall 0.9 m and more to the side of the sensor, whose returns lie farther and farther
  // apart: before it ends, a beam runs through the cells of the wall.
  std::vector<BeamEnd> ends;
  for (double x_m = 0.5; x_m < 15.0; x_m *= 1.03) ends.push_back(hit_at(x_m, 0.9 + 0.01 * x_m));
  CountedGrid lone(0.05, 400, 60);
  lone.count({0.0, 1.0, 0.0}, ends);
  for (std::size_t i = 1; i < ends.size(); ++i) ends[i].is_joined = true;
  CountedGrid joined(0.05, 400, 60);
  joined.count({0.0, 1.0, 0.0}, ends);
  const OccupancyGrid& without = lone.finish();
  const OccupancyGrid& with = joined.finish();
  int num_freed = 0;
  for (double x_m = 1.0; x_m < 13.0; x_m += 0.05) {
    const CellIndex cell = cell_of(subcell_at(x_m / 0.05, (1.9 + 0.01 * x_m) / 0.05));
    num_freed += without.state(cell) == CellState::kFree;
    EXPECT_NE(with.state(cell), CellState::kFree) << x_m;
  }
  EXPECT_GT(num_freed, 50) << "else the joints had nothing to keep";
  EXPECT_EQ(with.state({100, 38 - 6}), CellState::kFree);
}

TEST(ScanInsertion, LogOddsStayWithinTheirBounds) {
  CountedGrid counted(1.0, 10, 1);
  for (int i = 0; i < 100; ++i) counted.count({0.5, 0.5, 0.0}, {hit_at(5.0)});
  const OccupancyGrid& grid = counted.finish();
  EXPECT_EQ(grid.log_odds({5, 0}), static_cast<float>(counted.params.max_log_odds));
  EXPECT_EQ(grid.log_odds({2, 0}), static_cast<float>(counted.params.min_log_odds));
}

TEST(ScanInsertion, WhatIsPassedOftenIsFreeWhateverItsHitsAndTheOtherWayRound) {
  CountedGrid counted(1.0, 10, 1);
  for (int i = 0; i < 10; ++i) counted.count({0.5, 0.5, 0.0}, {hit_at(i < 1 ? 3.0 : 5.0)});
  for (int i = 0; i < 10; ++i) counted.count({0.5, 0.5, 0.0}, {hit_at(i < 4 ? 5.0 : 8.0)});
  const OccupancyGrid& grid = counted.finish();
  EXPECT_EQ(grid.state({3, 0}), CellState::kFree) << "a person stood there once";
  EXPECT_EQ(grid.state({5, 0}), CellState::kOccupied) << "glass: 13 beams stopped, 6 did not";
}

TEST(ScanInsertion, BandsTogetherCountWhatTheWholeCounts) {
  constexpr std::int32_t kColumns = 50;
  constexpr std::int32_t kRows = 37;
  std::mt19937_64 generator = testing::make_generator();
  std::uniform_real_distribution<double> place_m(-1.0, 4.0);  // some ends outside: 2.5 m x 1.85 m
  std::uniform_real_distribution<double> inside_m(0.1, 1.8);
  CountedGrid whole(0.05, kColumns, kRows);
  OccupancyGrid cut({}, 0.05, kColumns, kRows);
  std::vector<std::uint16_t> num_hits(cut.values().size(), 0);
  std::vector<EvidenceBand> bands;
  for (const auto& [first, end] : {std::pair{0, 1}, {1, 9}, {9, 30}, {30, kRows}}) {
    const auto begin = static_cast<std::size_t>(first * kColumns);
    const auto size = static_cast<std::size_t>((end - first) * kColumns);
    bands.emplace_back(first,
                       kColumns,
                       std::span(cut.values()).subspan(begin, size),
                       std::span(num_hits).subspan(begin, size));
  }
  for (int scan = 0; scan < 40; ++scan) {
    const Pose2 T_grid_sensor{inside_m(generator), inside_m(generator), 0.1 * scan};
    std::vector<BeamEnd> ends;
    for (int i = 0; i < 30; ++i) {
      ends.push_back({place_m(generator), place_m(generator), i % 5 != 0, i % 5 > 1});
    }
    whole.count(T_grid_sensor, ends);
    for (EvidenceBand& band : bands) band.count(T_grid_sensor, 0.05, ends, whole.params);
  }
  for (EvidenceBand& band : bands) band.finish(whole.params);
  EXPECT_EQ(whole.finish().values(), cut.values());
  EXPECT_GT(std::ranges::count_if(cut.values(), [](float v) { return v > 0.0F; }), 5);
}

TEST(ScanInsertion, BeamsFromOutsideCountInsideOnly) {
  CountedGrid counted(1.0, 4, 4);
  counted.count({-5.5, 1.5, 0.0}, {hit_at(20.0)});
  counted.count({2.5, -5.5, 0.0}, {hit_at(0.0, 20.0), hit_at(0.0, -3.0)});
  const OccupancyGrid& grid = counted.finish();
  for (CellIndex cell; cell.row < 4; ++cell.row) {
    for (cell.column = 0; cell.column < 4; ++cell.column) {
      const bool is_crossed = cell.row == 1 || cell.column == 2;
      EXPECT_EQ(grid.state(cell), is_crossed ? CellState::kFree : CellState::kUnknown);
    }
  }
}

TEST(ScanInsertion, ParametersAreChecked) {
  EXPECT_THROW(ScanInsertionParams{.hit_log_odds = 0.0}.validate(), ParameterError);
  EXPECT_THROW(ScanInsertionParams{.pass_log_odds = 0.1}.validate(), ParameterError);
  EXPECT_THROW(ScanInsertionParams{.no_returns_per_pass = 0}.validate(), ParameterError);
  EXPECT_THROW(ScanInsertionParams{.max_log_odds = -1.0}.validate(), ParameterError);
  EXPECT_THROW(ScanInsertionParams{.min_log_odds = std::nan("")}.validate(), ParameterError);
}

}  // namespace setsquare::scan_insertion_test
