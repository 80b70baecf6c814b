// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/graph/heading_evidence.hpp"
#include "setsquare/graph/heading_frames.hpp"

namespace setsquare {

/// A proposal taken for the direction of one frame's walls.
struct AssignedProposal {
  std::size_t keyframe = 0;
  std::size_t frame = 0;
  double offset_rad = 0.0;  ///< Measured drift plus frame's offset, unwrapped near the rough drift.
  double information = 0.0;  ///< In 1/rad^2, beliefs included, before robust weights.
};

/// The proposals that fit a frame to `gate_rad` where the drift is about `found.drift_rad`, in the
/// order of the keyframes; a proposal goes to the frame that it fits best. `building_sigma_rad` is
/// added to each proposal's own sigma. Where much of the log fits no frame, what fits one may do so
/// by chance: informations are scaled by the square of the share that is explained.
[[nodiscard]] std::vector<AssignedProposal> assign_heading_proposals(
    const std::vector<HeadingEvidence>& keyframes,
    const HeadingFrames& found,
    double period_rad,
    double gate_rad,
    double building_sigma_rad);

}  // namespace setsquare
