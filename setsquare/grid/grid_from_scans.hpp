// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "setsquare/core/pose2.hpp"
#include "setsquare/grid/beam_ends.hpp"
#include "setsquare/grid/changed_cells.hpp"
#include "setsquare/grid/occupancy_grid.hpp"
#include "setsquare/grid/placed_scan.hpp"
#include "setsquare/grid/scan_insertion.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

struct GridFromScansParams {
  double resolution_m = 0.05;    ///< Side of a cell; doubled until max_num_cells suffices.
  double min_spacing_m = 0.1;    ///< A scan nearer to the last one inserted, and ...
  double min_turn_rad = 0.0873;  ///< ... turned less (5 degrees), adds nothing and is left out.
  double margin_m = 0.5;         ///< Unknown border around everything seen.
  double max_num_cells = 1e8;
  int num_threads = 1;  ///< Any number gives the same grid.
  BeamEndParams beams = {};
  ScanInsertionParams insertion = {};
  ChangedCellParams changes = {};

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// A grid that holds all that the scans saw. Its rows run along the direction `grid_heading_rad`
/// of the map frame; where that is 0, the lower left corner lies at whole centimetres.
///
/// 1. Scans that hardly moved are left out.
/// 2. The extent of all beams makes the grid.
/// 3. Band of rows by band of rows, the beams that end in a cell and those that pass through it are
///    counted (EvidenceBand): small enough for the cache, and a piece of work for a thread.
/// 4. Scans of several sessions (PlacedScan::recency) are counted session by session, from the
/// newest
///    to the oldest. Where walls changed what is older does not count (ChangedCells).
/// 5. The counts become log-odds.
[[nodiscard]] OccupancyGrid grid_from_scans(std::span<const PlacedScan> scans,
                                            double grid_heading_rad = 0.0,
                                            const GridFromScansParams& params = {});

/// The same, and where walls changed from session to session.
[[nodiscard]] GridWithChanges grid_with_changes(std::span<const PlacedScan> scans,
                                                double grid_heading_rad = 0.0,
                                                const GridFromScansParams& params = {});

}  // namespace setsquare
