// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/headings/doubted_turns.hpp"
#include "setsquare/headings/evidence.hpp"
#include "setsquare/headings/frames.hpp"
#include "setsquare/headings/heading_params.hpp"
#include "setsquare/headings/trace.hpp"

namespace setsquare {
/// A proposal taken for the direction of one frame's walls.
struct AssignedProposal {
  std::size_t keyframe = 0;
  std::size_t frame = 0;
  double offset_rad = 0.0;  ///< Measured drift plus frame's offset, unwrapped near the rough drift.
  double information = 0.0;  ///< In 1/rad^2, confidences included, before robust weights.
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

/// The headings after fusion, one value per keyframe unless it says otherwise. The map's axes are
/// those of the main frame of the building.
struct FusedHeadings {
  std::vector<double> heading_rad;        ///< Tracked heading plus drift; wrap before comparing.
  std::vector<double> drift_rad;          ///< What was added to the tracked heading.
  std::vector<double> weight;             ///< Weight of its proposals, 0 to 1.
  std::vector<double> heading_sigma_rad;  ///< Standard deviation against the main frame's walls;
                                          ///< infinite where no wall was seen in the whole log.
  /// The heading in the map by the accepted proposals, near heading_rad: the frame's
  /// offset taken off, the quarter turn decided. heading_rad where there are none.
  std::vector<double> measured_heading_rad;
  /// Information of that measurement, in 1/rad^2, robust weight included; 0 where there is none.
  std::vector<double> measured_information;
  std::vector<int> frame;  ///< Whose walls were seen: index of `frames`; -1 where none has weight.
  std::vector<HeadingFrame> frames;  ///< Of the building, the main one first.
  std::vector<DoubtedTurn> doubted;  ///< As doubted_turns() has them.
};

/// Headings from the walls' directions and the tracked rotations; no loop is closed, nothing is
/// snapped. A building may have several frames: wings at odd angles.
///
/// 1. The walls' offset is traced through outliers and from wing to wing (trace_headings).
/// 2. Drift and changes of frame are kept apart (find_heading_frames).
/// 3. Each proposal is taken for a measurement of the frame that it fits, if it fits any; a
///    keyframe between two wings may measure both.
/// 4. Robust least squares over the chain: a measurement binds its keyframe's drift and its frame's
///    offset, weighted by its confidence and sharpness; each tracked rotation binds two neighbours.
///    Weights of Geman-McClure, graduated from full weights (the scale falls to inlier_rad), each
///    step one exact solve (HeadingEquations).
/// 5. Where walls are known to be turned, one after the other in the order of `turned`, they are
///    those of another frame: one already seen, or one of their own, whose offset is measured by
///    what is known of the turn and by the tracked rotations. Solved again. Turns that this decides
///    are no longer doubted.
[[nodiscard]] FusedHeadings fuse_headings(const std::vector<HeadingEvidence>& keyframes,
                                          const HeadingFusionParams& params = {},
                                          std::span<const TurnedWalls> turned = {});

}  // namespace setsquare
