// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/matching/match_result.hpp"

namespace setsquare {

/// The same answer for the robot's poses: T_base_base from T_sensor_sensor by the scans' mountings
/// (Scan::T_base_sensor), with the information and the degenerate direction in the reference
/// robot's frame.
[[nodiscard]] MatchResult match_result_of_base(const MatchResult& of_sensor,
                                               const Pose2& T_base_sensor_reference,
                                               const Pose2& T_base_sensor_current);

}  // namespace setsquare
