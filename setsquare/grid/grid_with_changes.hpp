// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A separate header, so that users of a map need not include the rest of the grid.
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <vector>

#include "setsquare/grid/occupancy_grid.hpp"

namespace setsquare {

/// Where walls, furniture or doors are not what an older session saw.
struct ChangedPlace {
  Eigen::Vector2d place_m = Eigen::Vector2d::Zero();  ///< Mean of its cells, in the map frame.
  std::size_t num_cells = 0;                          ///< As many of the grid.
  bool is_gone = false;  ///< What stood there is gone; else what stands there is new.
};

/// A grid, and where walls changed from session to session.
struct GridWithChanges {
  OccupancyGrid grid;                 ///< What stands by the newest session that saw it.
  std::vector<ChangedPlace> changes;  ///< The largest first; none of a single session.
};

}  // namespace setsquare
