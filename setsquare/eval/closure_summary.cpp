// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/closure_summary.hpp"

#include <cassert>

namespace setsquare {

void add_verdict(ClosureVerdict verdict, ClosureCounts& counts) {
  ++counts.num_closures;
  switch (verdict) {
    case ClosureVerdict::kRight:
      ++counts.num_right;
      break;
    case ClosureVerdict::kWrong:
      ++counts.num_wrong;
      break;
    case ClosureVerdict::kBorderline:
      ++counts.num_borderline;
      break;
    case ClosureVerdict::kDisputed:
      ++counts.num_disputed;
      break;
    case ClosureVerdict::kUnjudged:
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
    const ClosureVerdict verdict = judgements[k].verdict;
    add_verdict(verdict, is_accepted ? summary.accepted : summary.refused);
    const bool is_heavy = closures[k].weight > kHeavyClosure;
    if (is_accepted && is_heavy && verdict == ClosureVerdict::kWrong) ++summary.num_heavy_wrong;
  }
  return summary;
}

}  // namespace setsquare
