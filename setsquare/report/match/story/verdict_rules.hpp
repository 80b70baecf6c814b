// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/report/match/story/story.hpp"

namespace setsquare {

/// The rules of the default matcher's verdict (matching/verdict.cpp) with what was measured, in the
/// order in which they decide. A plain twin of the verdict for people: a test holds that both come
/// to the same status.
[[nodiscard]] std::vector<VerdictRule> verdict_rules(const MatchResult& result,
                                                     const MatchTrace& trace,
                                                     std::size_t num_points,
                                                     const AnswerParams& params);

/// What the rules come to: the first that fails decides.
[[nodiscard]] MatchStatus status_of_rules(const std::vector<VerdictRule>& rules);

}  // namespace setsquare
