// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from grid_from_scans: which sessions' beams count where walls changed from one to the next.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/grid/grid_with_changes.hpp"
#include "setsquare/grid/scan_insertion.hpp"

namespace setsquare {

/// When cells have changed.
struct ChangedCellParams {
  double sure_log_odds =
      1.4;                    ///< A session is sure of a cell from here on: four beams or two hits.
  double same_wall_m = 0.1;   ///< A wall that both saw, no farther off than this, did not change.
  std::size_t min_cells = 3;  ///< Of a place that is told.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Counts of a grid's cells, row by row, as EvidenceBand counts them.
struct CellCounts {
  std::span<float> num_passes;
  std::span<std::uint16_t> num_hits;
};

/// Adds the counts of older sessions to those of newer ones, but where walls changed.
///
/// A session and the newer ones contradict each other in a cell if the one is sure that it is free
/// and the other that it is occupied. The cell changed if no wall that is seen by the one that sees
/// a free cell is within `same_wall_m`: else it is the same wall, seen a little off. So did the
/// cells next to it that are contradicted, too: those at the frame of a door. Of a cell that
/// changed what is older no longer counts.
class ChangedCells {
 public:
  ChangedCells(std::int32_t num_columns,
               std::int32_t num_rows,
               double resolution_m,
               const ScanInsertionParams& insertion,
               const ChangedCellParams& params);

  /// Sessions come from the newest to the oldest. `newer`: of all that are newer, and afterwards of
  /// this one, too.
  void add_older(const CellCounts& newer, const CellCounts& older);

  /// The places that changed, the largest first. A cell that changed is free or occupied by
  /// `counts`, of all sessions.
  [[nodiscard]] std::vector<ChangedPlace> places(const CellCounts& counts,
                                                 const Pose2& T_map_grid) const;

 private:
  enum class Sure : std::uint8_t { kNothing, kFree, kOccupied };

  [[nodiscard]] Sure sure_of(const CellCounts& counts, std::size_t cell) const;
  /// Whether a cell about this one is surely occupied.
  [[nodiscard]] bool is_wall_near(const std::vector<Sure>& sure, std::size_t cell) const;
  /// Visits the neighbours of a cell, at most `reach` columns and rows off.
  template <typename Visit>
  void visit_about(std::size_t cell, std::int32_t reach, Visit visit) const;

  std::int32_t num_columns_;
  std::int32_t num_rows_;
  double resolution_m_;
  ScanInsertionParams insertion_;
  ChangedCellParams params_;
  std::int32_t reach_;  ///< same_wall_m in cells.
  std::vector<std::uint8_t> is_changed_;
};

}  // namespace setsquare
