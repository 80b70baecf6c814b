// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What an audit found, for run.json and for `setsquare audit --json`.
#pragma once

#include <nlohmann/json.hpp>

#include "setsquare/map/map.hpp"

namespace setsquare {

/// The counts of the pairs; null where the map was not audited.
[[nodiscard]] nlohmann::ordered_json json_from_audit(const Map& map);

/// An array of the doubts, numbered from 1 as on map.png and the page.
[[nodiscard]] nlohmann::ordered_json json_from_doubts(const Map& map);

}  // namespace setsquare
