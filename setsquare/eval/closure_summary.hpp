// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "setsquare/eval/closure_judgement.hpp"

namespace setsquare {

/// How many closures were judged how.
struct ClosureCounts {
  std::size_t num_closures = 0;
  std::size_t num_right = 0;
  std::size_t num_wrong = 0;
  std::size_t num_borderline = 0;
  std::size_t num_disputed = 0;
  std::size_t num_unjudged = 0;

  [[nodiscard]] std::size_t num_judged() const { return num_right + num_wrong; }
};

/// Counts one more closure.
void add_verdict(ClosureTruth verdict, ClosureCounts& counts);

struct ClosureSummary {
  ClosureCounts accepted;
  ClosureCounts refused;
  /// Accepted closures that are wrong and still pull: of a weight above kHeavyClosure.
  std::size_t num_heavy_wrong = 0;
};

inline constexpr double kHeavyClosure = 0.3;

/// Counts the judgements of judge_closures(), one a closure, in the same order.
[[nodiscard]] ClosureSummary summarise_closures(std::span<const LoopClosure> closures,
                                                std::span<const ClosureJudgement> judgements);

}  // namespace setsquare
