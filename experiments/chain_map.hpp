// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "setsquare/core/pose2.hpp"
#include "setsquare/sim/sensing/simulated_scan.hpp"

namespace setsquare::experiments {

/// The scans laid out at these poses (one a scan) as an occupancy grid with the track in it; a PNG
/// file's bytes. Its rows run along `axis_rad` of the map frame.
[[nodiscard]] std::string map_png(std::span<const SimulatedScan> scans,
                                  std::span<const Pose2> T_map_base,
                                  double axis_rad);

}  // namespace setsquare::experiments
