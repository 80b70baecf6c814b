// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "setsquare/eval/closure_judgement.hpp"

namespace setsquare::app {

[[nodiscard]] nlohmann::ordered_json json_from(const ClosureCounts& counts);
[[nodiscard]] nlohmann::ordered_json json_from(const ClosureSummary& summary);

/// A table for people, with a sentence on what still pulls.
[[nodiscard]] std::string table_from(const ClosureSummary& summary);

/// The accepted closures that are wrong, borderline or disputed, in order, as an array.
[[nodiscard]] nlohmann::ordered_json json_of_doubtful(std::span<const LoopClosure> closures,
                                                      std::span<const ClosureJudgement> judgements);

/// The same, one a line with tabs, under a header line.
[[nodiscard]] std::string list_of_doubtful(std::span<const LoopClosure> closures,
                                           std::span<const ClosureJudgement> judgements);

}  // namespace setsquare::app
