// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "setsquare/map/map.hpp"
#include "setsquare/report/map/closure_markers.hpp"

namespace setsquare::live_app {

/// Accepted closures between scans that are placed, where they are placed now.
[[nodiscard]] inline std::vector<ClosureLine> lines_of_closures(const Map& map) {
  std::vector<ClosureLine> lines;
  for (const MappedClosure& mapped : closures_of_placed(map)) {
    if (!mapped.closure.is_accepted) continue;
    lines.push_back({map.scans[mapped.scan_i].T_map_base.translation(),
                     map.scans[mapped.scan_j].T_map_base.translation(),
                     !mapped.closure.is_outvoted()});
  }
  return lines;
}

}  // namespace setsquare::live_app
