// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "apps/setsquare/map/run.hpp"

namespace setsquare::app {

/// The content of run.json: what was read, how it went, with which options and parameters. The
/// same log and options give the same bytes; times are in timing.json.
[[nodiscard]] std::string run_json(const MapOptions& options, const MapRun& run);

}  // namespace setsquare::app
