// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare::benchmarks {

/// A half-turn scan of a made-up office (12 m by 9 m, desks, a round column, a door to a corridor)
/// with a centimetre of range noise, the same at every call. The sensor must stand inside.
[[nodiscard]] Scan office_scan(const Pose2& T_map_sensor, std::size_t num_beams);

/// Where the pairs that the benchmarks match are taken: a step and a turn apart.
inline constexpr Pose2 kReferencePose = {4.0, 3.0, 0.15};
inline constexpr Pose2 kCurrentPose = {4.7, 3.4, 0.55};

}  // namespace setsquare::benchmarks
