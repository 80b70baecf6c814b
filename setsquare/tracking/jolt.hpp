// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from scan_tracker, its only caller: tested with poses of its own.
#pragma once

#include "setsquare/core/pose2.hpp"
#include "setsquare/tracking/scan_tracker_params.hpp"

namespace setsquare {

/// Whether a place is so far from where the robot was going that the step there asks for a witness.
/// By odometry or by the last motion; robots seldom step aside so far from one scan to the next.
[[nodiscard]] bool is_jolt(const Pose2& expected, const Pose2& place, const JoltParams& params);

/// Whether the witness, the last scan matched with this one without a guess, speaks against a jolt:
/// it has the scan nearer to where the robot was going than `place` is, and nearer to that than to
/// `place`. What it has farther off is most often another place that looks the same.
[[nodiscard]] bool is_contradicted(const Pose2& expected,
                                   const Pose2& place,
                                   const Pose2& by_last_scan,
                                   const JoltParams& params);

}  // namespace setsquare
