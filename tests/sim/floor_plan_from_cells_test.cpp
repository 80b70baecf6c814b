// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/floor_plan_from_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::floor_plan_from_cells_test {

/// Cells of 0.5 m from a picture, whose last row is the lowest.
PlanCells cells_from(const std::vector<std::string>& picture) {
  PlanCells cells;
  cells.resolution_m = 0.5;
  cells.num_columns = picture.empty() ? 0 : picture[0].size();
  cells.num_rows = picture.size();
  for (auto row = picture.rbegin(); row != picture.rend(); ++row) {
    for (const char c : *row) cells.is_filled.push_back(c == '#' ? 1 : 0);
  }
  return cells;
}

double length_m(const FloorPlan& plan) {
  double sum_m = 0.0;
  for (const PlanSegment& segment : plan.segments) {
    sum_m += (segment.end_m - segment.start_m).norm();
  }
  return sum_m;
}

TEST(FloorPlanFromCells, ABlockHasFourWalls) {
  PlanCells cells = cells_from({"....", ".###", ".###"});
  cells.T_map_cells = {10.0, 20.0, rad_from_deg(90.0)};
  const FloorPlan plan = floor_plan_from_cells(cells, Material::kPillar);
  ASSERT_EQ(plan.segments.size(), 4U);
  EXPECT_NEAR(length_m(plan), 5.0, 1e-12);
  for (const PlanSegment& segment : plan.segments) {
    EXPECT_EQ(segment.material, Material::kPillar);
    for (const Eigen::Vector2d& end_m : {segment.start_m, segment.end_m}) {
      // Columns run along the map's y, rows along its -x.
      EXPECT_TRUE(std::abs(end_m.x() - 10.0) < 1e-9 || std::abs(end_m.x() - 9.0) < 1e-9);
      EXPECT_TRUE(std::abs(end_m.y() - 20.5) < 1e-9 || std::abs(end_m.y() - 22.0) < 1e-9);
    }
  }
}

TEST(FloorPlanFromCells, ARoomHasAnInsideAndAnOutside) {
  const FloorPlan plan = floor_plan_from_cells(cells_from({"####", "#..#", "####"}));
  EXPECT_EQ(plan.segments.size(), 8U);
  EXPECT_NEAR(length_m(plan), 0.5 * (14 + 6), 1e-12);
}

TEST(FloorPlanFromCells, EveryEdgeOnceAndNoMore) {
  std::mt19937_64 generator = testing::make_generator();
  for (int run = 0; run < 20; ++run) {
    std::vector<std::string> picture(12, std::string(17, '.'));
    for (std::string& row : picture) {
      for (char& c : row) c = testing::uniform(generator, 0.0, 1.0) < 0.4 ? '#' : '.';
    }
    const auto at = [&picture](int column, int row) {
      const bool is_inside = row >= 0 && row < 12 && column >= 0 && column < 17;
      return is_inside && picture[row][column] == '#';
    };
    int num_edges = 0;
    for (int row = 0; row <= 12; ++row) {
      for (int column = 0; column <= 17; ++column) {
        num_edges += at(column, row) != at(column - 1, row);
        num_edges += at(column, row) != at(column, row - 1);
      }
    }
    const FloorPlan plan = floor_plan_from_cells(cells_from(picture));
    EXPECT_NEAR(length_m(plan), 0.5 * num_edges, 1e-9);
    // Joined as far as they go: no two segments continue each other.
    for (const PlanSegment& one : plan.segments) {
      for (const PlanSegment& other : plan.segments) {
        const Eigen::Vector2d along = one.end_m - one.start_m;
        const Eigen::Vector2d next = other.end_m - other.start_m;
        const bool is_parallel = std::abs(along.x() * next.y() - along.y() * next.x()) < 1e-12;
        EXPECT_FALSE(is_parallel && (one.end_m - other.start_m).norm() < 1e-9);
      }
    }
  }
}

TEST(FloorPlanFromCells, NothingFilledNothingDrawn) {
  EXPECT_TRUE(floor_plan_from_cells(cells_from({"...", "..."})).segments.empty());
  PlanCells none;
  none.resolution_m = 0.05;
  EXPECT_TRUE(floor_plan_from_cells(none).segments.empty());
}

TEST(FloorPlanFromCells, RefusesCellsThatAreNone) {
  PlanCells cells = cells_from({"##"});
  cells.resolution_m = 0.0;
  EXPECT_THROW(static_cast<void>(floor_plan_from_cells(cells)), ParameterError);
  cells = cells_from({"##", "##"});
  cells.num_rows = 3;
  EXPECT_THROW(static_cast<void>(floor_plan_from_cells(cells)), ParameterError);
  cells.num_rows = static_cast<std::size_t>(-1);  // times two columns it would wrap around
  EXPECT_THROW(static_cast<void>(floor_plan_from_cells(cells)), ParameterError);
}

}  // namespace setsquare::floor_plan_from_cells_test
