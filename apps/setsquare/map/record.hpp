// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "apps/setsquare/map/run.hpp"
#include "setsquare/report/map/run_json.hpp"

namespace setsquare::app {

/// What run.json records of a run of the command, apart from its map: the log, the options, the
/// parameters that decide most.
[[nodiscard]] RunRecord record_of(const MapOptions& options, const MapRun& run);

}  // namespace setsquare::app
