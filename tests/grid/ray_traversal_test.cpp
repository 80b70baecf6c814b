// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/grid/ray_traversal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/support/seed.hpp"

namespace setsquare::ray_traversal_test {

constexpr std::int64_t kCell = kSubcellsPerCell;

std::vector<CellIndex> cells_on_ray(SubcellPoint from, SubcellPoint to) {
  RayTraversal ray(from, to);
  std::vector<CellIndex> cells = {ray.cell()};
  for (std::int32_t step = 0; step < ray.num_steps(); ++step) {
    ray.advance();
    cells.push_back(ray.cell());
  }
  return cells;
}

/// Does the segment meet the cell (lower and left side included, upper and right ones not)? In
/// whole numbers: the cell's range of the ray's parameter, as fractions, by each axis.
bool crosses_plainly(SubcellPoint from, SubcellPoint to, CellIndex cell) {
  struct Fraction {  // value / length, of positive length
    std::int64_t value;
    std::int64_t length;
    bool operator<(const Fraction& other) const {
      return value * other.length < other.value * length;
    }
  };
  Fraction enter{0, 1};
  Fraction leave{1, 1};
  bool is_enter_open = false;
  bool is_leave_open = false;
  const auto cut = [&](std::int64_t a, std::int64_t b, std::int64_t low, std::int64_t high) {
    if (a == b) return low <= a && a < high;
    const bool is_growing = b > a;
    const std::int64_t length = std::abs(b - a);
    const Fraction first{is_growing ? low - a : a - high, length};
    const Fraction last{is_growing ? high - a : a - low, length};
    const bool is_first_open = !is_growing;
    const bool is_last_open = is_growing;
    if (enter < first) {
      enter = first;
      is_enter_open = is_first_open;
    } else if (!(first < enter)) {
      is_enter_open = is_enter_open || is_first_open;
    }
    if (last < leave) {
      leave = last;
      is_leave_open = is_last_open;
    } else if (!(leave < last)) {
      is_leave_open = is_leave_open || is_last_open;
    }
    return true;
  };
  const bool has_columns = cut(from.x, to.x, cell.column * kCell, (cell.column + 1) * kCell);
  const bool has_rows = cut(from.y, to.y, cell.row * kCell, (cell.row + 1) * kCell);
  if (!has_columns || !has_rows || leave < enter) return false;
  return enter < leave || (!is_enter_open && !is_leave_open);
}

/// The plain twin: every cell around, tested on its own.
std::vector<CellIndex> cells_on_ray_plainly(SubcellPoint from, SubcellPoint to) {
  std::vector<CellIndex> cells;
  const CellIndex a = cell_of(from);
  const CellIndex b = cell_of(to);
  for (std::int32_t row = std::min(a.row, b.row) - 1; row <= std::max(a.row, b.row) + 1; ++row) {
    for (std::int32_t column = std::min(a.column, b.column) - 1;
         column <= std::max(a.column, b.column) + 1;
         ++column) {
      if (crosses_plainly(from, to, {column, row})) cells.push_back({column, row});
    }
  }
  return cells;
}

TEST(RayTraversal, VisitsExactlyTheCellsOfItsPlainTwin) {
  std::mt19937_64 generator = testing::make_generator();
  for (const std::int64_t span : {kCell, 4 * kCell, 40 * kCell}) {
    std::uniform_int_distribution<std::int64_t> coordinate(-span, span);
    for (int round = 0; round < 300; ++round) {
      const SubcellPoint from{coordinate(generator), coordinate(generator)};
      const SubcellPoint to{coordinate(generator), coordinate(generator)};
      std::vector<CellIndex> cells = cells_on_ray(from, to);
      std::sort(cells.begin(), cells.end());
      std::vector<CellIndex> plain = cells_on_ray_plainly(from, to);
      std::sort(plain.begin(), plain.end());
      // Through a corner the ray turns by way of a cell that it only touches.
      EXPECT_TRUE(std::includes(cells.begin(), cells.end(), plain.begin(), plain.end()));
      EXPECT_LE(cells.size() - plain.size(), 1U)
          << from.x << " " << from.y << " to " << to.x << " " << to.y;
      if (span > kCell) continue;
      EXPECT_EQ(cells.size(), plain.size());
    }
  }
}

TEST(RayTraversal, SuccessiveCellsShareASideAndTheLastHoldsTheEnd) {
  std::mt19937_64 generator = testing::make_generator();
  // A coarse lattice, so that rays often run through corners and along sides.
  std::uniform_int_distribution<std::int64_t> coordinate(-8, 8);
  for (int round = 0; round < 5000; ++round) {
    const SubcellPoint from{coordinate(generator) * kCell / 2, coordinate(generator) * kCell / 2};
    const SubcellPoint to{coordinate(generator) * kCell / 2, coordinate(generator) * kCell / 2};
    const std::vector<CellIndex> cells = cells_on_ray(from, to);
    EXPECT_EQ(cells.front(), cell_of(from));
    EXPECT_EQ(cells.back(), cell_of(to))
        << from.x << " " << from.y << " to " << to.x << " " << to.y;
    for (std::size_t i = 1; i < cells.size(); ++i) {
      EXPECT_EQ(std::abs(cells[i].column - cells[i - 1].column) +
                    std::abs(cells[i].row - cells[i - 1].row),
                1);
    }
    for (const CellIndex cell : cells_on_ray_plainly(from, to)) {
      EXPECT_NE(std::find(cells.begin(), cells.end(), cell), cells.end());
    }
  }
}

TEST(RayTraversal, AdvancesToARowAsByItsSteps) {
  std::mt19937_64 generator = testing::make_generator();
  for (const std::int64_t unit : {std::int64_t{1}, kCell / 2}) {  // the latter: through corners
    std::uniform_int_distribution<std::int64_t> coordinate(-30 * kCell / unit, 30 * kCell / unit);
    for (int round = 0; round < 300; ++round) {
      const SubcellPoint from{coordinate(generator) * unit, coordinate(generator) * unit};
      const SubcellPoint to{coordinate(generator) * unit, coordinate(generator) * unit};
      const std::vector<CellIndex> cells = cells_on_ray(from, to);
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (i > 0 && cells[i].row == cells[i - 1].row) continue;
        RayTraversal ray(from, to);
        ASSERT_EQ(ray.num_steps_to_row(cells[i].row), static_cast<std::int32_t>(i));
        ray.advance_to_row(cells[i].row);
        for (std::size_t next = i; next < cells.size(); ++next, ray.advance()) {
          ASSERT_EQ(ray.cell(), cells[next]);
        }
      }
    }
  }
}

TEST(RayTraversal, StandsStillInOneCell) {
  EXPECT_EQ(cells_on_ray({5, 5}, {5, 5}), (std::vector<CellIndex>{{0, 0}}));
  EXPECT_EQ(cells_on_ray({-1, 0}, {-kCell, kCell - 1}), (std::vector<CellIndex>{{-1, 0}}));
}

TEST(RayTraversal, LongestRayStaysExact) {
  const std::int64_t far = (kMaxRayCells - 1) * kCell;
  RayTraversal ray({0, 0}, {far, far - 1});
  const CellIndex end = cell_of({far, far - 1});
  for (std::int32_t step = 0; step < ray.num_steps(); ++step) {
    ray.advance();
    ASSERT_LE(std::abs(ray.cell().column - ray.cell().row), 1);
  }
  EXPECT_EQ(ray.cell(), end);
}

TEST(Subcell, FloorsTowardsTheLowerLeft) {
  EXPECT_EQ(subcell_at(0.0, 1.0), (SubcellPoint{0, kCell}));
  EXPECT_EQ(subcell_at(-0.25, 2.5), (SubcellPoint{-kCell / 4, 5 * kCell / 2}));
  EXPECT_EQ(cell_of(subcell_at(-0.001, 3.999)), (CellIndex{-1, 3}));
}

}  // namespace setsquare::ray_traversal_test
