// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdlib>

#include "setsquare/grid/occupancy_grid.hpp"

namespace setsquare {

/// A place in a grid in whole numbers: kSubcellsPerCell subcells make a cell, and subcell 0 begins
/// at the grid's lower left corner. Whole numbers make the traversal exact.
struct SubcellPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;

  bool operator==(const SubcellPoint&) const = default;
};

inline constexpr std::int64_t kSubcellBits = 12;
inline constexpr std::int64_t kSubcellsPerCell = std::int64_t{1} << kSubcellBits;
/// A ray may be this long along an axis, so that products of its sides fit 64 bits.
inline constexpr std::int64_t kMaxRayCells = std::int64_t{1} << 18;

/// The subcell in which a place lies, given in cells from the grid's lower left corner.
[[nodiscard]] SubcellPoint subcell_at(double x_cells, double y_cells);

[[nodiscard]] constexpr CellIndex cell_of(SubcellPoint point) {
  return {static_cast<std::int32_t>(point.x >> kSubcellBits),
          static_cast<std::int32_t>(point.y >> kSubcellBits)};
}

/// Walks the cells that a ray crosses, after Amanatides and Woo 1987, in whole numbers: no cell is
/// missed or added by rounding. Successive cells share a side; the last is that of the end. A ray
/// through a corner turns towards the growing coordinate first.
class RayTraversal {
 public:
  /// The ray must not be longer than kMaxRayCells along either axis.
  RayTraversal(SubcellPoint from, SubcellPoint to);

  /// Cells after the first one.
  [[nodiscard]] std::int32_t num_steps() const { return num_steps_; }
  [[nodiscard]] CellIndex cell() const { return cell_; }
  /// To the next cell; at most num_steps times.
  void advance() {
    // Masks instead of a branch that no processor can predict: benchmarks/stages/grid_benchmark.
    const std::int64_t column_mask = lead_ >> 63;  // all ones where the column is next
    const auto column_mask32 = static_cast<std::int32_t>(column_mask);
    cell_.column += column_step_ & column_mask32;
    cell_.row += row_step_ & ~column_mask32;
    lead_ = (lead_ - row_lead_) + (both_leads_ & column_mask);
  }
  /// Steps from the current cell to the ray's first one in another row, which must lie between the
  /// current one and the end's. In constant time.
  [[nodiscard]] std::int32_t num_steps_to_row(std::int32_t row) const;
  /// That many steps at once: the same cell, to the last bit, as by advance().
  void advance_to_row(std::int32_t row);

 private:
  /// Steps along the row's axis before the step into another row.
  [[nodiscard]] std::int64_t num_columns_before_row(std::int32_t row) const;

  CellIndex cell_;
  std::int32_t column_step_;
  std::int32_t row_step_;
  std::int32_t num_steps_;
  /// Where the ray meets the next column less where it meets the next row, times both its sides.
  std::int64_t lead_;
  std::int64_t column_lead_;
  std::int64_t row_lead_;
  std::int64_t both_leads_;  ///< Their sum.
};

}  // namespace setsquare
