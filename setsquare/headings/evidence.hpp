// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace setsquare {

/// One direction that a keyframe's walls propose for its heading.
struct HeadingProposal {
  double heading_rad = 0.0;  ///< Heading in the building, known modulo the period only.
  double sigma_rad = 0.0;    ///< Standard deviation if the proposal is the right one.
  double confidence = 0.0;   ///< Belief that it is the right one, 0 to 1.
};

/// What is known of a keyframe's heading before fusion.
struct HeadingEvidence {
  double tracked_heading_rad = 0.0;  ///< By tracking: drifts; modulo a whole turn.
  /// Standard deviation of the tracked rotation from the keyframe before; unused for the first.
  double step_sigma_rad = 0.0;
  /// Whether matches of scans about that step confirm it: tracking did not slip there.
  bool is_step_confirmed = false;
  std::vector<HeadingProposal> proposals;  ///< None where no wall was seen.
  /// Of the place that it stands at. Where several scanners leave keyframes, each is one of as many
  /// that see the same walls, and counts as so much of a keyframe; its proposals' confidences
  /// are scaled likewise (share_place()).
  double share_of_place = 1.0;
};

/// Keyframes [first, end) whose walls stand to the building's at another angle than they seem to:
/// what several places show that were seen before or behind as well.
struct TurnedWalls {
  std::size_t first = 0;
  std::size_t end = 0;
  double turn_rad = 0.0;   ///< To be added to the headings that the walls gave without it ...
  double sigma_rad = 0.0;  ///< ... and its standard deviation.
};

}  // namespace setsquare
