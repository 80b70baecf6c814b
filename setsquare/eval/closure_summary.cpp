// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/closure_summary.hpp"

#include <cassert>

namespace setsquare {

void add_verdict(ClosureTruth verdict, ClosureCounts& counts) {
  ++counts.num_closures;
  switch (verdict) {
    case ClosureTruth::kRight:
      ++counts.num_right;
      break;
    case ClosureTruth::kWrong:
      ++counts.num_wrong;
      break;
    case ClosureTruth::kBorderline:
      ++counts.num_borderline;
      break;
    case ClosureTruth::kDisputed:
      ++counts.num_disputed;
      break;
    case ClosureTruth::kUnjudged:
      ++counts.num_unjudged;
      break;
  }
}

ClosureSummary summarise_closures(std::span<const LoopClosure> closures,
                                  std::span<const ClosureJudgement> judgements) {
  assert(closures.size() == judgements.size());
  ClosureSummary summary;
  for (std::size_t k = 0; k < closures.size(); ++k) {
    const bool is_accepted = closures[k].is_accepted;
    const ClosureTruth verdict = judgements[k].verdict;
    add_verdict(verdict, is_accepted ? summary.accepted : summary.refused);
    const bool is_heavy = closures[k].weight > kHeavyClosure;
    if (is_accepted && is_heavy && verdict == ClosureTruth::kWrong) ++summary.num_heavy_wrong;
  }
  return summary;
}

}  // namespace setsquare
