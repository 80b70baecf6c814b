// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// The one mounting behind many: each is a difference of two rounded poses, so each is off by up to
/// the rounding. Per coordinate: the median, rounded to the log's own unit, and zero where it is
/// within the rounding. `rounding` in m and rad; 0 where the mountings are exact.
[[nodiscard]] Pose2 settle_mounting(std::vector<Pose2> mountings, double rounding);

/// Whether mountings differ by more than rounding explains (5 cm or 2 degrees beyond it): then the
/// log's laser poses are not the robot's plus a mounting, but for instance corrected poses.
[[nodiscard]] bool is_mounting_varying(const Pose2& settled,
                                       const Pose2& measured,
                                       double rounding);

}  // namespace setsquare
