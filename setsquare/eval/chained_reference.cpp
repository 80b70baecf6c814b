// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/chained_reference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "setsquare/core/error.hpp"

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

void HopParams::validate() const {
  const std::array<std::pair<const char*, double>, 5> fields = {
      {{"max_time_s", max_time_s},
       {"max_distance_m", max_distance_m},
       {"max_rotation_rad", max_rotation_rad},
       {"translation_sigma_m", translation_sigma_m},
       {"rotation_sigma_rad", rotation_sigma_rad}}};
  for (const auto& [name, value] : fields) {
    if (!(value > 0.0) || !std::isfinite(value)) throw ParameterError(name, "must be positive");
  }
}

ReferencePose expected_pose(const ChainedPose& chained) {
  return {chained.T_i_j,
          std::sqrt(chained.variance.translation_m2),
          std::sqrt(chained.variance.rotation_rad2)};
}

ChainedReference::ChainedReference(std::span<const Relation> relations,
                                   const Trajectory& trajectory,
                                   const HopParams& hop_params,
                                   const RelationGraphParams& graph_params)
    : graph_(relations, graph_params), trajectory_(trajectory), hop_params_(hop_params) {
  hop_params_.validate();
}

std::vector<ChainEnd> ChainedReference::ends_near(Timestamp stamp) const {
  std::vector<ChainEnd> ends;
  const auto here = trajectory_.find(stamp);
  if (here) {
    const PoseVariance hop = {hop_params_.translation_sigma_m * hop_params_.translation_sigma_m,
                              hop_params_.rotation_sigma_rad * hop_params_.rotation_sigma_rad};
    const auto stamps = graph_.stamps();
    const auto span_ns = static_cast<std::int64_t>(1e9 * hop_params_.max_time_s);
    auto candidate = std::lower_bound(stamps.begin(), stamps.end(), Timestamp{stamp.ns - span_ns});
    for (; candidate != stamps.end() && candidate->ns - stamp.ns <= span_ns; ++candidate) {
      const auto there = trajectory_.find(*candidate);
      if (!there) continue;
      const Pose2 T_here_there = here->pose.inverse() * there->pose;
      if (T_here_there.translation().norm() > hop_params_.max_distance_m) continue;
      if (std::abs(T_here_there.theta_rad) > hop_params_.max_rotation_rad) continue;
      const bool is_same = std::abs(candidate->ns - stamp.ns) <= kSameStamp_ns;
      ends.push_back({static_cast<std::size_t>(candidate - stamps.begin()),
                      T_here_there,
                      is_same ? PoseVariance{} : hop});
    }
  }
  return ends;
}

std::vector<ReferencePose> ChainedReference::expected(Timestamp stamp_i, Timestamp stamp_j) const {
  const std::vector<ChainEnd> ends_i = ends_near(stamp_i);
  const std::vector<ChainEnd> ends_j = ends_near(stamp_j);
  const auto first = graph_.chain(ends_i, ends_j);
  if (!first || first->pairs.empty()) return {};
  const auto second = graph_.chain(ends_i, ends_j, first->pairs);
  if (!second) return {expected_pose(*first)};
  return {expected_pose(*first), expected_pose(*second)};
}

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
