// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "setsquare/drawing/svg_canvas.hpp"
#include "setsquare/report/match/story/story.hpp"

namespace setsquare {

/// A numbered part of a match report.
struct MatchSection {
  std::string title;
  std::string caption;
  SvgCanvas figure;
  bool is_table = false;  ///< The proposals: a page shows them as a table instead.
};

/// The figures of a match in the order in which the match was made.
[[nodiscard]] std::vector<MatchSection> match_sections(const MatchStory& story);

/// "intel.clf: scan 120 (reference) and scan 140 (current), preset default"
[[nodiscard]] std::string match_subtitle(const MatchStory& story);

}  // namespace setsquare
