// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/tracking/submap_refinement.hpp"
#include "setsquare/tracking/tracked_pose.hpp"

namespace setsquare {

/// Whether the walls leave a direction, or a turn, open.
[[nodiscard]] bool is_open(const SubmapFit& fit, const SubmapRefinementParams& params);

/// A scan tracked where it fits the submap: how, and what the walls leave open there.
[[nodiscard]] TrackedPose answer_of(const SubmapFit& fit, const SubmapRefinementParams& params);

}  // namespace setsquare
