// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "setsquare/graph/heading_drift.hpp"

namespace setsquare {

/// Parameters of fuse_headings. Angles in rad.
struct HeadingFusionParams {
  HeadingDriftParams drift;
  double building_sigma_rad = rad_from_deg(0.3);  ///< Of a proposal, beside its own sigma.
  double inlier_rad = rad_from_deg(1.0);  ///< Residual at which a proposal's weight falls to 1/4.
  int num_iterations = 30;                ///< Of reweighting.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// The headings after fusion.
struct FusedHeadings {
  std::vector<double> heading_rad;  ///< One a keyframe: tracked heading plus drift, unwrapped.
  std::vector<double> drift_rad;    ///< What was added to the tracked heading.
  std::vector<double> weight;       ///< How far the proposal that was meant was believed, 0 to 1.
};

/// Headings from the walls' directions and the tracked rotations; no loop is closed, nothing is
/// snapped.
///
/// A keyframe may have any number of proposals (Mapper gives one at most); one of them is used.
///
/// 1. The drift is traced through outliers and ambiguity (trace_heading_drift); it tells which of a
///    keyframe's proposals is meant, the nearest one, and in which quarter turn.
/// 2. Robust least squares over the chain: the proposal meant binds its keyframe, weighted by its
///    confidence and sharpness, each tracked rotation binds two neighbours. Weights of
///    Geman-McClure, graduated from full weights (the scale falls to inlier_rad), each step one
///    tridiagonal solve.
[[nodiscard]] FusedHeadings fuse_headings(const std::vector<HeadingEvidence>& keyframes,
                                          const HeadingFusionParams& params = {});

}  // namespace setsquare
