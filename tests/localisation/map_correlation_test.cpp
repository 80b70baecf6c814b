// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/map_correlation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::map_correlation_test {

OccupancyGrid random_floor(std::mt19937_64& generator) {
  std::uniform_int_distribution<int> side(20, 300);
  OccupancyGrid grid({}, 0.1, side(generator), side(generator));
  std::uniform_real_distribution<double> chance(0.0, 1.0);
  for (std::int32_t row = 0; row < grid.num_rows(); ++row) {
    for (std::int32_t column = 0; column < grid.num_columns(); ++column) {
      const bool is_known = (row / 16 + column / 16) % 3 != 0;
      const double fate = chance(generator);
      grid.values()[grid.index({column, row})] = !is_known ? 0.0F : (fate < 0.02 ? 2.0F : -1.0F);
    }
  }
  return grid;
}

SurfaceSamples random_samples(std::mt19937_64& generator, std::size_t count) {
  std::normal_distribution<float> place(0.0F, 6.0F);
  SurfaceSamples samples;
  for (std::size_t i = 0; i < count; ++i) {
    samples.x_m.push_back(place(generator));
    samples.y_m.push_back(place(generator));
    samples.normal_x.push_back(0.0F);
    samples.normal_y.push_back(0.0F);
    samples.weight_m.push_back(0.1F);
  }
  samples.count = count;
  return samples;
}

/// The same grid and sums, cell by cell and sample by sample.
class PlainCorrelation {
 public:
  explicit PlainCorrelation(const WallDistance& walls) : walls_(walls) {}

  /// 2 on a wall, 1 beside one, -1 in free space, 0 else: above the value of unknown cells.
  [[nodiscard]] int value(int column, int row) const {
    if (kind(column, row) == 'w') return 2;
    for (const auto& [x, y] :
         {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)}) {
      if (kind(column + x, row + y) == 'w') return 1;
    }
    return kind(column, row) == 'f' ? -1 : 0;
  }
  /// Whether free space lies in the cell, or within some steps from cell to cell that meet no wall.
  [[nodiscard]] bool may_hold_sensor(int column, int row, int num_steps = 5) const {
    if (column < 0 || row < 0 || 2 * column >= walls_.num_columns() ||
        2 * row >= walls_.num_rows()) {
      return false;
    }
    for (int y = 2 * row; y < 2 * row + 2; ++y) {
      for (int x = 2 * column; x < 2 * column + 2; ++x) {
        if (walls_.state({x, y}) == CellState::kFree) return true;
      }
    }
    if (num_steps == 0 || kind(column, row) == 'w') return false;
    return may_hold_sensor(column - 1, row, num_steps - 1) ||
           may_hold_sensor(column + 1, row, num_steps - 1) ||
           may_hold_sensor(column, row - 1, num_steps - 1) ||
           may_hold_sensor(column, row + 1, num_steps - 1);
  }
  [[nodiscard]] int sum(const SurfaceSamples& samples,
                        double rotation_rad,
                        int column,
                        int row) const {
    const double c = std::cos(rotation_rad) / 0.2;
    const double s = std::sin(rotation_rad) / 0.2;
    int total = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double x = samples.x_m[i];
      const double y = samples.y_m[i];
      total += value(column + static_cast<int>(std::floor(c * x - s * y + 0.5)),
                     row + static_cast<int>(std::floor(s * x + c * y + 0.5)));
    }
    return total;
  }

 private:
  [[nodiscard]] char kind(int column, int row) const {
    int num_free = 0;
    int num_unknown = 0;
    for (int y = 2 * row; y < 2 * row + 2; ++y) {
      for (int x = 2 * column; x < 2 * column + 2; ++x) {
        if (x < 0 || y < 0 || x >= walls_.num_columns() || y >= walls_.num_rows()) continue;
        const CellState state = walls_.state({x, y});
        if (state == CellState::kOccupied) return 'w';
        num_free += state == CellState::kFree;
        num_unknown += state == CellState::kUnknown;
      }
    }
    return num_free > num_unknown ? 'f' : 'u';
  }

  const WallDistance& walls_;
};

TEST(MapCorrelation, ProposesTheLocalMaximaOfThePlainSums) {
  auto generator = testing::make_generator();
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  for (int trial = 0; trial < 6; ++trial) {
    const WallDistance walls(random_floor(generator));
    const MapCorrelation correlation(walls);
    ASSERT_NEAR(correlation.cell_m(), 0.2, 1e-12);
    const PlainCorrelation plain(walls);
    const SurfaceSamples samples = random_samples(generator, 60);
    const double rotation_rad = angle(generator);
    const int num_columns = (walls.num_columns() + 1) / 2;
    const int num_rows = (walls.num_rows() + 1) / 2;
    std::map<std::pair<int, int>, int> sums;
    int highest = 0;
    for (int row = 0; row < num_rows; ++row) {
      for (int column = 0; column < num_columns; ++column) {
        sums[{column, row}] = plain.sum(samples, rotation_rad, column, row);
        highest = std::max(highest, sums[{column, row}]);
      }
    }
    const int floor = std::max(1, highest / 2);
    MapCorrelation::Scratch scratch;
    std::vector<MapProposal> proposals;
    correlation.propose(samples, rotation_rad, floor, scratch, proposals);
    bool has_highest = false;
    std::set<std::pair<int, int>> proposed;
    for (const MapProposal& proposal : proposals) {
      const int column = static_cast<int>(std::floor(proposal.T_grid_sensor.x_m / 0.2));
      const int row = static_cast<int>(std::floor(proposal.T_grid_sensor.y_m / 0.2));
      EXPECT_EQ(proposal.correlation, (sums[{column, row}]));
      EXPECT_GE(proposal.correlation, floor);
      EXPECT_TRUE(plain.may_hold_sensor(column, row));
      has_highest |= proposal.correlation == highest;
      proposed.insert({column, row});
    }
    const bool may_be_there = std::any_of(sums.begin(), sums.end(), [&](const auto& entry) {
      return entry.second == highest &&
             plain.may_hold_sensor(entry.first.first, entry.first.second);
    });
    EXPECT_TRUE(has_highest || !may_be_there);
    // None is left out, a little beyond free space neither.
    for (const auto& [cell, sum] : sums) {
      const auto [column, row] = cell;
      const bool is_inside =
          column > 0 && row > 0 && column + 1 < num_columns && row + 1 < num_rows;
      if (!is_inside || sum < floor || !plain.may_hold_sensor(column, row)) continue;
      const int before = std::max({sums[{column - 1, row - 1}],
                                   sums[{column, row - 1}],
                                   sums[{column + 1, row - 1}],
                                   sums[{column - 1, row}]});
      const int after = std::max({sums[{column + 1, row + 1}],
                                  sums[{column, row + 1}],
                                  sums[{column - 1, row + 1}],
                                  sums[{column + 1, row}]});
      if (sum > before && sum >= after) {
        EXPECT_TRUE(proposed.contains({column, row}));
      }
    }
  }
}

TEST(MapCorrelation, RefusesMoreSamplesThanFitIntoItsSums) {
  auto generator = testing::make_generator();
  const WallDistance walls(random_floor(generator));
  const MapCorrelation correlation(walls);
  MapCorrelation::Scratch scratch;
  std::vector<MapProposal> proposals;
  EXPECT_THROW(correlation.propose(random_samples(generator, 61), 0.0, 1, scratch, proposals),
               std::invalid_argument);
}

}  // namespace setsquare::map_correlation_test
