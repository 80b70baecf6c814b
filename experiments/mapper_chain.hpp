// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "setsquare/map/map.hpp"
#include "setsquare/sim/sensing/simulated_scan.hpp"

namespace setsquare::experiments {

/// The full mapper with its defaults over all scans. With `odometry_seed` it is told besides what
/// drifting wheels measure (OdometryModel with its defaults).
[[nodiscard]] Map track_by_mapper(std::span<const SimulatedScan> scans,
                                  std::optional<std::uint64_t> odometry_seed = {});

}  // namespace setsquare::experiments
