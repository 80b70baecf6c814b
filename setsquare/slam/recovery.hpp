// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "setsquare/slam/submap_refinement.hpp"

namespace setsquare {

/// A pose found again.
struct RecoveredFit {
  SubmapFit fit;
  bool is_far = false;  ///< Found by the search over the full circle, not near the last pose.
};

/// Looks for a scan that does not fit where it was tracked: refinements from starts that stand
/// where the last scan stood and are turned, first by little, then all around. Nothing where no
/// start is convincingly better than `tracked`.
[[nodiscard]] std::optional<RecoveredFit> recover(const TrackingProblem& problem,
                                                  const SubmapFit& tracked,
                                                  const Pose2& T_odom_last,
                                                  const RecoveryParams& params,
                                                  const SubmapRefinementParams& refinement);

}  // namespace setsquare
