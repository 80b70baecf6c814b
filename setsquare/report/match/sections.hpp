// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setsquare/report/match/figures/figures.hpp"
#include "setsquare/report/match/story/story.hpp"

namespace setsquare {

/// A numbered part of a match report: what the picture (report_svg.cpp) and the page
/// (report_html.cpp) have in common.
struct MatchSection {
  std::string title;
  std::string caption;
  Figure figure;
  std::optional<StoryTable> table = std::nullopt;  ///< A page shows it instead of the figure.
};

/// The figures of a match in the order in which the match was made.
[[nodiscard]] std::vector<MatchSection> match_sections(const MatchStory& story);

/// "intel.clf: scan 120 (reference) and scan 140 (current), preset default"
[[nodiscard]] std::string match_subtitle(const MatchStory& story);

}  // namespace setsquare
