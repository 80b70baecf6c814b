// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/headings/evidence.hpp"
#include "setsquare/headings/heading_params.hpp"
#include "setsquare/headings/trace.hpp"

namespace setsquare {

/// Keyframes between which the walls turned against the tracked rotation by more than tracking
/// errs: it slipped, or these are other walls, not square to those before. The walls cannot tell
/// which.
struct DoubtedTurn {
  std::size_t from = 0;     ///< The last keyframe that shows the walls as they were before ...
  std::size_t to = 0;       ///< ... and the first that shows them as they are behind.
  double turned_rad = 0.0;  ///< Of the walls' offset.
};

/// The doubted turns of a track that have steps which nobody confirmed: first those in one step, of
/// which two neighbours are sure; then those that the drift shows, which do not overlap.
/// `drift_rad`: rough, one per keyframe (HeadingFrames).
[[nodiscard]] std::vector<DoubtedTurn> doubted_turns(const std::vector<HeadingEvidence>& keyframes,
                                                     const HeadingTrace& trace,
                                                     const std::vector<double>& drift_rad,
                                                     const HeadingTraceParams& trace_params = {},
                                                     const DoubtedTurnParams& params = {});

/// Without those that are decided: where walls begin or end that are known to be turned.
[[nodiscard]] std::vector<DoubtedTurn> without_settled(std::vector<DoubtedTurn> turns,
                                                       std::span<const TurnedWalls> turned);

/// Each turn once, in the order of the keyframes: a step and a drift that overlap are one turn,
/// over the keyframes of both and by the larger of the two.
[[nodiscard]] std::vector<DoubtedTurn> distinct_turns(std::vector<DoubtedTurn> turns);

}  // namespace setsquare
