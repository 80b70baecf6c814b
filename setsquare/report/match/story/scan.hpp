// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/paper/paper_matcher.hpp"
#include "setsquare/report/match/story/story.hpp"

namespace setsquare {

/// Prepares a scan for the pictures: thinning, M(theta), dominant direction, profiles.
[[nodiscard]] StoryScan story_scan(const Scan& scan, const PaperParams& params);

/// Shifts along x' and y' of the reference (eq. 4) that a relative pose means.
struct AxisShifts {
  double along_m = 0.0;
  double across_m = 0.0;
};
[[nodiscard]] AxisShifts shifts_of_pose(const Pose2& T_reference_current,
                                        double theta_reference_rad);

/// The correlation curves of the two scans at the rotation of a relative pose.
[[nodiscard]] StoryRotation story_rotation(const StoryScan& reference,
                                           const StoryScan& current,
                                           const Pose2& T_reference_current,
                                           const ShiftSearch& search);

}  // namespace setsquare
