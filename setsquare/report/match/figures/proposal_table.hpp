// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "setsquare/report/match/story/story.hpp"

namespace setsquare {

/// The heads of the columns of the table of proposals, units included.
[[nodiscard]] std::vector<std::string> proposal_table_head(const MatchStory& story);

/// The cells of one proposal, one a head.
[[nodiscard]] std::vector<std::string> proposal_table_row(const MatchStory& story,
                                                          std::size_t proposal);

}  // namespace setsquare
