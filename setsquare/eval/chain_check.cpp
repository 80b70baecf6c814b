// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/chain_check.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace setsquare {
namespace {

ClosureError error_of(const ChainedPose& chained, const Relation& relation) {
  LoopClosure closure;
  closure.T_i_j = chained.T_i_j;
  return closure_error(closure, relation.T_reference_current, 0.0);
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
    ++check.num_relations;
    const ChainEnd reference = {*graph.find(relation.reference_stamp), {}, {}};
    const ChainEnd current = {*graph.find(relation.current_stamp), {}, {}};
    const auto [a, b] = std::minmax(reference.node, current.node);
    std::vector<JoinedPair> avoided = {{a, b}};
    const auto first = graph.chain({&reference, 1}, {&current, 1}, avoided);
    if (!first) continue;
    ++check.num_chained;
    const ClosureError error = error_of(*first, relation);
    translation_m.push_back(error.translation_m);
    rotation_rad.push_back(error.rotation_rad);
    const bool is_off = !error.is_within(params.limits);
    avoided.insert(avoided.end(), first->pairs.begin(), first->pairs.end());
    const auto second = graph.chain({&reference, 1}, {&current, 1}, avoided);
    const bool is_disputed =
        second && error_of(*second, relation).is_within(params.limits) == is_off;
    check.num_off += is_off ? 1 : 0;
    check.num_disputed += is_disputed ? 1 : 0;
    check.num_off_disputed += is_off && is_disputed ? 1 : 0;
  }
  check.translation_m = error_statistics(translation_m);
  check.rotation_rad = error_statistics(rotation_rad);
  return check;
}

}  // namespace setsquare
