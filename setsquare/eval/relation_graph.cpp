// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/relation_graph.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/eval/pose_pairs.hpp"

namespace setsquare {
namespace {

/// All stamps of the relations, those within rounding of the one before left out.
std::vector<Timestamp> stamps_of(std::span<const Relation> relations) {
  std::vector<Timestamp> stamps;
  for (const Relation& relation : relations) {
    stamps.push_back(relation.reference_stamp);
    stamps.push_back(relation.current_stamp);
  }
  std::sort(stamps.begin(), stamps.end());
  const auto is_same = [](Timestamp a, Timestamp b) { return b.ns - a.ns <= kSameStamp_ns; };
  stamps.erase(std::unique(stamps.begin(), stamps.end(), is_same), stamps.end());
  return stamps;
}

JoinedPair pair_of(std::size_t node, std::size_t other) {
  return {std::min(node, other), std::max(node, other)};
}

}  // namespace

void RelationGraphParams::validate() const {
  const std::array<std::pair<const char*, double>, 4> fields = {
      {{"translation_sigma_m", translation_sigma_m},
       {"rotation_sigma_rad", rotation_sigma_rad},
       {"max_translation_sigma_m", max_translation_sigma_m},
       {"max_rotation_sigma_rad", max_rotation_sigma_rad}}};
  for (const auto& [name, value] : fields) {
    if (!(value > 0.0) || !std::isfinite(value)) throw ParameterError(name, "must be positive");
  }
}

RelationGraph::RelationGraph(std::span<const Relation> relations, const RelationGraphParams& params)
    : params_(params), stamps_(stamps_of(relations)), neighbours_(stamps_.size()) {
  params_.validate();
  for (const Relation& relation : relations) {
    const std::size_t reference = *find(relation.reference_stamp);
    const std::size_t current = *find(relation.current_stamp);
    if (reference == current) continue;
    const Pose2& T_reference_current = relation.T_reference_current;
    neighbours_[reference].push_back({current, T_reference_current.inverse()});
    neighbours_[current].push_back({reference, T_reference_current});
  }
}

std::optional<std::size_t> RelationGraph::find(Timestamp stamp) const {
  const auto after = std::lower_bound(stamps_.begin(), stamps_.end(), stamp);
  std::optional<std::size_t> nearest;
  std::int64_t nearest_ns = kSameStamp_ns;
  for (auto node = after == stamps_.begin() ? after : after - 1;
       node != stamps_.end() && node <= after;
       ++node) {
    const std::int64_t distance_ns = std::abs(node->ns - stamp.ns);
    if (distance_ns > nearest_ns) continue;
    nearest_ns = distance_ns;
    nearest = static_cast<std::size_t>(node - stamps_.begin());
  }
  return nearest;
}

double RelationGraph::cost_of(const PoseVariance& variance) const {
  const double max_m = params_.max_translation_sigma_m;
  const double max_rad = params_.max_rotation_sigma_rad;
  return variance.translation_m2 / (max_m * max_m) + variance.rotation_rad2 / (max_rad * max_rad);
}

RelationGraph::Label RelationGraph::prepend(const Pose2& T_before_node,
                                            const PoseVariance& step,
                                            const Label& label) const {
  Label longer;
  longer.T_node_j = T_before_node * label.T_node_j;
  const double squared_lever_m2 = label.T_node_j.translation().squaredNorm();
  longer.variance.translation_m2 =
      label.variance.translation_m2 + step.translation_m2 + step.rotation_rad2 * squared_lever_m2;
  longer.variance.rotation_rad2 = label.variance.rotation_rad2 + step.rotation_rad2;
  longer.cost = cost_of(longer.variance);
  return longer;
}

std::vector<RelationGraph::Label> RelationGraph::labels_to(
    std::span<const ChainEnd> ends_j, std::span<const JoinedPair> avoided) const {
  Label unreached;
  unreached.cost = std::numeric_limits<double>::infinity();
  std::vector<Label> labels(stamps_.size(), unreached);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto offer = [&](std::size_t node, std::size_t next, const Label& found) {
    if (!(found.cost <= 1.0) || found.cost >= labels[node].cost) return;
    labels[node] = found;
    labels[node].next = next;
    open.emplace(found.cost, node);
  };
  for (const ChainEnd& end : ends_j) {
    Label first;
    first.T_node_j = end.T_place_node.inverse();
    first.variance = end.variance;
    first.cost = cost_of(first.variance);
    offer(end.node, end.node, first);
  }
  const PoseVariance step = {params_.translation_sigma_m * params_.translation_sigma_m,
                             params_.rotation_sigma_rad * params_.rotation_sigma_rad};
  while (!open.empty()) {
    const std::size_t node = open.top().second;
    open.pop();
    if (std::exchange(labels[node].is_settled, true)) continue;
    for (const Neighbour& neighbour : neighbours_[node]) {
      if (labels[neighbour.node].is_settled) continue;
      const JoinedPair pair = pair_of(node, neighbour.node);
      if (std::find(avoided.begin(), avoided.end(), pair) != avoided.end()) continue;
      offer(neighbour.node, node, prepend(neighbour.T_node_here, step, labels[node]));
    }
  }
  return labels;
}

std::optional<ChainedPose> RelationGraph::chain(std::span<const ChainEnd> ends_i,
                                                std::span<const ChainEnd> ends_j,
                                                std::span<const JoinedPair> avoided) const {
  const std::vector<Label> labels = labels_to(ends_j, avoided);
  std::optional<ChainedPose> best;
  std::size_t first = 0;
  for (const ChainEnd& end : ends_i) {
    if (!labels[end.node].is_settled) continue;
    const Label whole = prepend(end.T_place_node, end.variance, labels[end.node]);
    if (!(whole.cost <= 1.0) || (best && whole.cost >= best->cost)) continue;
    best = ChainedPose{whole.T_node_j, whole.variance, whole.cost, {}};
    first = end.node;
  }
  if (!best) return std::nullopt;
  for (std::size_t node = first; labels[node].next != node; node = labels[node].next) {
    best->pairs.push_back(pair_of(node, labels[node].next));
  }
  return best;
}

}  // namespace setsquare
