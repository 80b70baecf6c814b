// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/paper/paper_matcher.hpp"
#include "setsquare/report/match/story/story.hpp"
#include "setsquare/scan/match_result.hpp"

namespace setsquare {

/// "x 1.234 m, y -0.056 m, rotation 12.34 deg"
[[nodiscard]] std::string words_of_pose(const Pose2& pose);

/// "34.5 %"
[[nodiscard]] std::string words_of_share(double share);

/// The default matcher's answer with its evidence, a sentence each. The rules name the one that
/// decided.
[[nodiscard]] std::vector<std::string> evidence_in_words(const MatchResult& result,
                                                         const std::vector<VerdictRule>& rules);

/// The paper's answer with its evidence, a sentence each.
[[nodiscard]] std::vector<std::string> evidence_in_words(const MatchResult& result,
                                                         const PaperParams& params);

}  // namespace setsquare
