// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/core/angle.hpp"

namespace setsquare {

/// One direction that a keyframe's walls propose for its heading.
struct HeadingProposal {
  double heading_rad = 0.0;  ///< Heading in the building, known modulo the period only.
  double sigma_rad = 0.0;    ///< Standard deviation if the proposal is the right one.
  double confidence = 0.0;   ///< Belief that it is the right one, 0 to 1.
};

/// What is known of a keyframe's heading before fusion.
struct HeadingEvidence {
  double tracked_heading_rad = 0.0;  ///< By tracking: smooth, drifts.
  /// Standard deviation of the tracked rotation from the keyframe before; unused for the first.
  double step_sigma_rad = 0.0;
  std::vector<HeadingProposal> proposals;  ///< None where no wall was seen.
};

/// Parameters of trace_heading_drift.
struct HeadingDriftParams {
  double period_rad = 0.5 * kPi;                ///< Of the proposals.
  double bin_rad = rad_from_deg(0.5);           ///< Of the drift; divides the period.
  double inlier_rad = rad_from_deg(2.0);        ///< A proposal this far off tells nothing.
  double step_cost = 0.7;                       ///< Of one bin of drift between two keyframes ...
  double certain_step_rad = rad_from_deg(0.5);  ///< ... whose rotation is this certain, or better.
  std::size_t max_step_bins = 2;                ///< Of drift between keyframes of certain rotation.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// The drift of each keyframe's tracked heading (true heading less tracked heading, in rad) by
/// dynamic programming (Viterbi): the path through the bins of the drift, a circle of one period,
/// that pays least for proposals missed and for drift between neighbours. Outliers cost a bounded
/// amount, so the chain passes them; no threshold, no initial value. The path is continuous: it is
/// unwrapped along the keyframes, the first one in [-period / 2, period / 2).
[[nodiscard]] std::vector<double> trace_heading_drift(const std::vector<HeadingEvidence>& keyframes,
                                                      const HeadingDriftParams& params = {});

}  // namespace setsquare
