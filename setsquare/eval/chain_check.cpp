// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/chain_check.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "setsquare/eval/chained_reference.hpp"

namespace setsquare {
namespace {

/// A relation between two nodes by the chains of the others: none, one or two poses.
std::vector<ReferencePose> expected_by_others(const RelationGraph& graph,
                                              const ChainEnd& reference,
                                              const ChainEnd& current) {
  const auto [a, b] = std::minmax(reference.node, current.node);
  std::vector<JoinedPair> avoided = {{a, b}};
  const auto first = graph.chain({&reference, 1}, {&current, 1}, avoided);
  if (!first) return {};
  avoided.insert(avoided.end(), first->pairs.begin(), first->pairs.end());
  const auto second = graph.chain({&reference, 1}, {&current, 1}, avoided);
  if (!second) return {expected_pose(*first)};
  return {expected_pose(*first), expected_pose(*second)};
}

}  // namespace

ChainCheck check_chains(std::span<const Relation> relations, const ChainCheckParams& params) {
  const RelationGraph graph(relations, params.graph);
  ChainCheck check;
  std::vector<double> translation_m;
  std::vector<double> rotation_rad;
  for (const Relation& relation : relations) {
    const double seconds = seconds_between(relation.reference_stamp, relation.current_stamp);
    if (std::abs(seconds) < params.min_time_s) continue;
    LoopClosure closure;
    closure.T_i_j = relation.T_reference_current;
    const ChainEnd reference = {*graph.find(relation.reference_stamp), {}, {}};
    const ChainEnd current = {*graph.find(relation.current_stamp), {}, {}};
    const ClosureJudgement judgement = judge_closure(
        closure, expected_by_others(graph, reference, current), std::nullopt, params.limits);
    add_verdict(judgement.verdict, check.verdicts);
    if (judgement.verdict == ClosureTruth::kUnjudged) continue;
    translation_m.push_back(judgement.error.translation_m);
    rotation_rad.push_back(judgement.error.rotation_rad);
  }
  check.translation_m = error_statistics(translation_m);
  check.rotation_rad = error_statistics(rotation_rad);
  return check;
}

}  // namespace setsquare
