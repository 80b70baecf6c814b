// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// The drift of the tracked heading at one keyframe: true heading less tracked heading.
struct DriftAtScan {
  std::size_t scan_index = 0;
  double drift_rad = 0.0;
};

/// Lays the tracked motion out again with corrected headings: the drift is interpolated between
/// keyframes (constant before the first and after the last), each scan's heading is the tracked one
/// plus its drift, and each tracked displacement is turned by the drift half-way. The first scan
/// stands at the origin. `drifts` are in the order of the scans and may be empty.
[[nodiscard]] std::vector<Pose2> assemble_track(std::span<const Pose2> T_odom_sensor,
                                                std::span<const DriftAtScan> drifts);

}  // namespace setsquare
