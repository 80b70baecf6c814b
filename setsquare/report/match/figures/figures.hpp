// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "setsquare/drawing/svg_canvas.hpp"
#include "setsquare/report/match/story/story.hpp"

namespace setsquare {

/// Rows of panels have this width.
inline constexpr double kFigureWidth_px = 1320.0;

/// The panels of a figure, from left to right, row by row: a picture places them in rows, a page
/// breaks them where its window is narrow.
using Figure = std::vector<SvgCanvas>;

// --- Of the paper's method (figures/paper.cpp) ---

/// The two scans, all returns and thinned: the paper's Figure 3.
[[nodiscard]] Figure thinning_figure(const MatchStory& story, const PaperEvidence& looked_at);

/// M(theta) of both scans over half a turn, with their dominant directions: eq. (7).
[[nodiscard]] Figure direction_figure(const PaperEvidence& looked_at);

/// Both scans' profiles at the dominant direction, across it and off it: the paper's Figure 2.
[[nodiscard]] Figure profile_figure(const PaperEvidence& looked_at);

/// Correlation against the shift along both axes, a curve per rotation, chosen shifts marked: eq.
/// (10).
[[nodiscard]] Figure correlation_figure(const PaperEvidence& looked_at);

// --- Of the default matcher (figures/search.cpp, figures/evidence.cpp) ---

/// The two scans as surfaces, with the coarse samples.
[[nodiscard]] Figure surface_figure(const SurfaceEvidence& looked_at);

/// Length of wall by the direction that it faces, and the correlation of the two scans' histograms
/// with the rotations that were proposed.
[[nodiscard]] Figure rotation_figure(const MatchStory& story, const SurfaceEvidence& looked_at);

/// The proposals: where they came from and where refinement took them; correlation against score.
[[nodiscard]] Figure search_figure(const SurfaceEvidence& looked_at);

/// What the scores of the best proposals are made of, in metres of wall.
[[nodiscard]] Figure evidence_figure(const SurfaceEvidence& looked_at);

// --- Of both (figures/overlay.cpp, figures/table.cpp) ---

/// The two scans overlaid as proposed, at the answer and at the runner-up, contradictions marked.
[[nodiscard]] Figure overlay_figure(const MatchStory& story);

/// The proposal that the overlay shows with the answer: the best of a different pose. Null without
/// such a proposal.
[[nodiscard]] const StoryProposal* best_other_proposal(const MatchStory& story);

/// Cells of text: the last column is of words, those before it of numbers where `has_numbers`.
struct StoryTable {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
  std::size_t marked_row = 0;  ///< The answer, or the rule that decided; beyond the last for none.
  bool has_numbers = true;
};

/// The proposals, one per row, with what they were measured by and why they lost.
[[nodiscard]] StoryTable proposal_table(const MatchStory& story);

/// The verdict's rules, what they ask and what was found.
[[nodiscard]] StoryTable rule_table(const SurfaceEvidence& looked_at);

[[nodiscard]] Figure table_figure(const StoryTable& table);

}  // namespace setsquare
