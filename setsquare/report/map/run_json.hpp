// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "setsquare/map/map.hpp"
#include "setsquare/map/run_record.hpp"

namespace setsquare {

/// The content of run.json: what was read, how it went, with which options and parameters. The
/// same map and record give the same bytes; times are in timing.json. `changes`: of the map's grid
/// (occupancy_grid_with_changes). Throws ParameterError where a
/// JSON text of the record is not what it should be.
[[nodiscard]] std::string run_json(const Map& map,
                                   const RunRecord& run,
                                   PoseOf pose_of,
                                   std::span<const ChangedPlace> changes = {});

}  // namespace setsquare
