// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/headings/evidence.hpp"
#include "setsquare/headings/heading_params.hpp"

namespace setsquare {

/// What trace_headings found, one value per keyframe.
struct HeadingTrace {
  /// Direction of the walls that are followed less tracked heading: the drift, and the offset of
  /// the frame that the walls belong to. Unwrapped along the keyframes but for changes of frame,
  /// which are less than half a period; the first one is in [-period / 2, period / 2).
  std::vector<double> offset_rad;
  std::vector<bool> is_change;  ///< The walls followed from here on are those of another frame.
};

/// Follows the walls of a building through a log by dynamic programming (Viterbi) over the bins of
/// their offset, a circle of one period. The path pays least in all for
/// - proposals passed by: a bounded amount, so that outliers do no harm;
/// - drift, by the size of each move in standard deviations of the tracked rotation: true drift is
///   slow, unless tracking was lost;
/// - changes of frame: a constant. Walls at another angle than before, and for long, are another
///   wing of the building, not drift.
/// No threshold, no initial value; time and memory grow with keyframes times bins.
[[nodiscard]] HeadingTrace trace_headings(const std::vector<HeadingEvidence>& keyframes,
                                          const HeadingTraceParams& params = {});

/// Cost of passing by a keyframe's proposals where the walls' offset is `offset_rad`, 0 to the
/// highest confidence.
[[nodiscard]] double passing_cost(const HeadingEvidence& keyframe,
                                  double offset_rad,
                                  const HeadingTraceParams& params);

}  // namespace setsquare
