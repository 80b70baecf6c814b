// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/floor_plan_from_cells.hpp"

#include <cmath>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

bool is_filled(const PlanCells& cells, std::size_t column, std::size_t row) {
  return cells.is_filled[row * cells.num_columns + column] != 0;
}

/// Joins the edges along one line between cells: `is_edge(i)` states whether its i-th piece is one,
/// `add(begin, end)` takes each run.
template <typename IsEdge, typename Add>
void join_runs(std::size_t num_pieces, const IsEdge& is_edge, const Add& add) {
  std::size_t begin = 0;
  bool is_in_run = false;
  for (std::size_t i = 0; i <= num_pieces; ++i) {
    const bool is_here = i < num_pieces && is_edge(i);
    if (is_here && !is_in_run) begin = i;
    if (!is_here && is_in_run) add(begin, i);
    is_in_run = is_here;
  }
}

/// Gathers segments between corners of cells.
class Outlines {
 public:
  Outlines(const PlanCells& cells, Material material) : cells_(cells), material_(material) {}

  void add(std::size_t column, std::size_t row, std::size_t end_column, std::size_t end_row) {
    plan_.segments.push_back({corner_m(column, row), corner_m(end_column, end_row), material_});
  }
  [[nodiscard]] FloorPlan take() { return std::move(plan_); }

 private:
  [[nodiscard]] Eigen::Vector2d corner_m(std::size_t column, std::size_t row) const {
    return cells_.T_map_cells * Eigen::Vector2d(cells_.resolution_m * static_cast<double>(column),
                                                cells_.resolution_m * static_cast<double>(row));
  }

  const PlanCells& cells_;
  Material material_;
  FloorPlan plan_;
};

}  // namespace

void PlanCells::validate() const {
  if (!(resolution_m > 0.0) || !std::isfinite(resolution_m)) {
    throw ParameterError("resolution_m", "must be above 0");
  }
  const bool is_consistent = num_columns == 0 ? is_filled.empty()
                                              : is_filled.size() % num_columns == 0 &&
                                                    is_filled.size() / num_columns == num_rows;
  if (!is_consistent) throw ParameterError("is_filled", "must hold num_columns x num_rows cells");
}

FloorPlan floor_plan_from_cells(const PlanCells& cells, Material material) {
  cells.validate();
  const std::size_t num_columns = cells.num_columns;
  const std::size_t num_rows = cells.num_rows;
  Outlines outlines(cells, material);
  for (std::size_t row = 0; row <= num_rows; ++row) {  // the line below the row
    const auto is_edge = [&](std::size_t column) {
      return (row > 0 && is_filled(cells, column, row - 1)) !=
             (row < num_rows && is_filled(cells, column, row));
    };
    join_runs(num_columns, is_edge, [&](std::size_t begin, std::size_t end) {
      outlines.add(begin, row, end, row);
    });
  }
  for (std::size_t column = 0; column <= num_columns; ++column) {  // the line left of the column
    const auto is_edge = [&](std::size_t row) {
      return (column > 0 && is_filled(cells, column - 1, row)) !=
             (column < num_columns && is_filled(cells, column, row));
    };
    join_runs(num_rows, is_edge, [&](std::size_t begin, std::size_t end) {
      outlines.add(column, begin, column, end);
    });
  }
  return outlines.take();
}

}  // namespace setsquare
