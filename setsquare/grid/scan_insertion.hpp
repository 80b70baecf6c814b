// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/grid/beam_ends.hpp"
#include "setsquare/grid/occupancy_grid.hpp"
#include "setsquare/grid/ray_traversal.hpp"

namespace setsquare {

/// How hits and passes become log-odds, natural logarithms. A cell is occupied where more than
/// about a quarter of the beams that reached it ended in it: thin and slanting walls are passed by
/// often, free space is hardly ever hit.
struct ScanInsertionParams {
  double hit_log_odds = 0.95;    ///< Of a return that lies in the cell.
  double pass_log_odds = -0.36;  ///< Of a beam that passed through the cell and returned.
  int no_returns_per_pass = 4;   ///< So many beams without return weigh as one that returned.
  double max_log_odds = 3.5;     ///< No cell is surer of being occupied.
  double min_log_odds = -2.5;    ///< No cell is surer of being free.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Counts the evidence of beams for the cells of some rows of a grid: plain numbers, so that
/// neither the order of the scans nor the bands that the grid is cut into make a difference. Passes
/// are counted in the float of each cell that will hold its log-odds, exact up to 2^24, so that a
/// large grid needs little more memory than itself.
class EvidenceBand {
 public:
  /// The band's cells lie row by row in `num_passes` and `num_hits`, both zero and the caller's.
  EvidenceBand(std::int32_t first_row,
               std::int32_t num_columns,
               std::span<float> num_passes,
               std::span<std::uint16_t> num_hits);

  [[nodiscard]] std::int32_t first_row() const { return first_row_; }
  [[nodiscard]] std::int32_t end_row() const { return end_row_; }

  /// Counts a scan's beams, those without return once, the others `no_returns_per_pass` times. A
  /// beam passes through all cells but its last. A cell in which a return of this scan lies, or
  /// the joint of two neighbouring ones on one surface, is passed by none of the scan's beams:
  /// walls seen at a grazing angle stay. `T_grid_sensor` from the lower left corner of cell (0, 0);
  /// what lies outside the band is left out.
  void count(const Pose2& T_grid_sensor,
             double resolution_m,
             std::span<const BeamEnd> ends,
             const ScanInsertionParams& params);

  /// The counts become log-odds, in the place of `num_passes`: 0 where nothing is known.
  void finish(const ScanInsertionParams& params);

 private:
  /// A cell that no beam of the scan passes, and what it held before.
  struct Kept {
    std::size_t index;
    float num_passes;
  };

  [[nodiscard]] bool contains(CellIndex cell) const {
    return cell.row >= first_row_ && cell.row < end_row_ && cell.column >= 0 &&
           cell.column < num_columns_;
  }
  [[nodiscard]] std::size_t index(CellIndex cell) const {
    return static_cast<std::size_t>(cell.row - first_row_) *
               static_cast<std::size_t>(num_columns_) +
           static_cast<std::size_t>(cell.column);
  }
  void hit(CellIndex cell);
  void keep(CellIndex cell);
  void keep_joint(SubcellPoint from, SubcellPoint to);
  void pass(SubcellPoint from, SubcellPoint to, float weight);

  std::int32_t first_row_;
  std::int32_t end_row_;
  std::int32_t num_columns_;
  std::span<float> num_passes_;  ///< In beams without return.
  std::span<std::uint16_t> num_hits_;
  std::vector<Kept> kept_;  ///< Of the scan that is being counted.
  std::vector<SubcellPoint> stops_;
};

}  // namespace setsquare
