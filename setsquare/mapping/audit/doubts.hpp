// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from audit, its only caller: what is told of a map, tested without scans.
#pragma once

#include <vector>

#include "setsquare/mapping/audit/audit.hpp"

namespace setsquare {

/// Where the map may be wrong: what contradicts it, the most told first, then what it does not
/// know, in the order of the track.
[[nodiscard]] std::vector<MapDoubt> doubts_of(const Map& map,
                                              const AuditFindings& findings,
                                              const AuditParams& params);

}  // namespace setsquare
