// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/map/run_record.hpp"
#include "setsquare/pipeline/map_log.hpp"

namespace setsquare {

/// What run.json records of a run, apart from its map: the log, the options, the parameters that
/// decide most.
[[nodiscard]] RunRecord record_of(const MappedLog& mapped);

}  // namespace setsquare
