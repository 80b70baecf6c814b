// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "apps/setsquare/map/run.hpp"
#include "setsquare/grid/occupancy_grid.hpp"
#include "setsquare/report/map/page.hpp"

namespace setsquare::app {

/// What report.html shows of a run. `grid` must outlive it.
[[nodiscard]] MapReport map_page(const MapOptions& options,
                                 const MapRun& run,
                                 const OccupancyGrid& grid);

}  // namespace setsquare::app
