// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/grid/occupancy_grid.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// How a scan changes a grid. Log-odds are natural logarithms.
struct ScanInsertionParams {
  double hit_log_odds = 0.85;          ///< Added once a scan to a cell in which a return lies.
  double pass_log_odds = -0.4;         ///< Added to a cell by every beam that passes through it.
  double max_log_odds = 3.5;           ///< No cell gets surer of being occupied.
  double min_log_odds = -2.5;          ///< No cell gets surer of being free.
  double max_return_range_m = 30.0;    ///< Farther returns count as no-returns.
  double max_no_return_range_m = 5.0;  ///< A no-return proves free space only this far.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Where a beam ends, in the sensor frame.
struct BeamEnd {
  double x_m = 0.0;
  double y_m = 0.0;
  bool is_return = false;  ///< Otherwise only free space is known up to there.
};

/// The ends of all beams that tell something, in their order.
[[nodiscard]] std::vector<BeamEnd> beam_ends(const Scan& scan, const ScanInsertionParams& params);

/// Marks the space along the beams as free and the returns' cells as occupied. A cell that holds a
/// return of this scan is not freed by the scan's other beams: walls seen at a grazing angle stay.
/// What lies outside the grid is left out.
void insert_beams(OccupancyGrid& grid,
                  const Pose2& T_map_sensor,
                  const std::vector<BeamEnd>& ends,
                  const ScanInsertionParams& params);

/// insert_beams of the scan's beam_ends.
void insert_scan(OccupancyGrid& grid,
                 const Pose2& T_map_sensor,
                 const Scan& scan,
                 const ScanInsertionParams& params = {});

}  // namespace setsquare
