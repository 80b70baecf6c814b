// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "setsquare/drawing/svg_canvas.hpp"
#include "setsquare/report/match/story/story.hpp"

namespace setsquare {

/// All figures of a match have this width.
inline constexpr double kFigureWidth_px = 1320.0;

/// The two scans, all returns and thinned: the paper's Figure 3.
[[nodiscard]] SvgCanvas scan_figure(const MatchStory& story);

/// M(theta) of both scans over half a turn, with their dominant directions: eq. (7).
[[nodiscard]] SvgCanvas direction_figure(const MatchStory& story);

/// Both scans' profiles at the dominant direction, across it and off it: the paper's Figure 2.
[[nodiscard]] SvgCanvas profile_figure(const MatchStory& story);

/// Correlation against the shift along both axes, a curve a rotation, chosen shifts marked: eq.
/// (10).
[[nodiscard]] SvgCanvas correlation_figure(const MatchStory& story);

/// The proposals, one a row, with what they were measured by and why they lost.
[[nodiscard]] SvgCanvas proposal_figure(const MatchStory& story);

/// The two scans overlaid at the answer and at the runner-up, contradictions marked.
[[nodiscard]] SvgCanvas overlay_figure(const MatchStory& story);

/// The proposal that the overlay shows beside the answer: the best that is another pose. Null where
/// there is none.
[[nodiscard]] const StoryProposal* best_other_proposal(const MatchStory& story);

}  // namespace setsquare
