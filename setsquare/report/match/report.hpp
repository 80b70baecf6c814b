// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "setsquare/report/match/story/story.hpp"

namespace setsquare {

/// The story of a match as one SVG picture.
[[nodiscard]] std::string match_report_svg(const MatchStory& story);

/// The same as one HTML page that needs no other file: figures, table of proposals, evidence. It is
/// well-formed XML too.
[[nodiscard]] std::string match_report_html(const MatchStory& story);

}  // namespace setsquare
