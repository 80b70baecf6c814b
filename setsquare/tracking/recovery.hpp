// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from scan_tracker, its only caller: matching without a guess is a separate step.
#pragma once

#include <optional>
#include <span>

#include "setsquare/surfaces/prepared_scan.hpp"
#include "setsquare/tracking/submap_refinement.hpp"

namespace setsquare {

/// A pose found again.
struct RecoveredFit {
  SubmapFit fit;
  bool is_far = false;  ///< Far from where the scan was expected: tracking could not find it.
};

/// Looks for a scan (its `surfaces`) that does not fit where it was tracked. The guess-free matcher
/// places it against the latest of the submap's keyframes, one after the other, anywhere and at any
/// turn; each proposal is refined in the whole submap. Nothing where none is convincingly better
/// than `tracked`: a place far from the expected one needs a match that stands alone and a high
/// score. Without `tracked` (after a gap in the log) nothing is expected: every place is far.
[[nodiscard]] std::optional<RecoveredFit> recover(const TrackingProblem& problem,
                                                  std::span<const KeyframePtr> keyframes,
                                                  const ScanSurfacesPtr& surfaces,
                                                  const std::optional<SubmapFit>& tracked,
                                                  const RecoveryParams& params,
                                                  const SubmapRefinementParams& refinement);

}  // namespace setsquare
