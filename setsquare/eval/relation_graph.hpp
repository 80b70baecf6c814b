// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Relations chained one to the next: where a robot was at one stamp, seen from another that no
// relation joins to it directly.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "setsquare/core/relation.hpp"

namespace setsquare {

/// Variances of a relative pose: of its position, along either axis, and of its heading.
struct PoseVariance {
  double translation_m2 = 0.0;
  double rotation_rad2 = 0.0;
};

struct RelationGraphParams {
  double translation_sigma_m = 0.03;              ///< Noise of one relation, along either axis.
  double rotation_sigma_rad = rad_from_deg(0.4);  ///< Noise of one relation.
  /// What a chain may come to: a third of what makes a closure wrong (0.3 m, 5 deg).
  double max_translation_sigma_m = 0.1;
  double max_rotation_sigma_rad = rad_from_deg(5.0 / 3.0);

  /// Throws ParameterError naming the first field that is not positive and finite.
  void validate() const;
};

/// A place where a chain may begin or end: a stamp of the graph, joined to the place in question by
/// a short hop.
struct ChainEnd {
  std::size_t node = 0;   ///< Index into RelationGraph::stamps().
  Pose2 T_place_node;     ///< The node, seen from the place.
  PoseVariance variance;  ///< Of that hop.
};

/// A pair of stamps that relations join, as indices into RelationGraph::stamps(), lower one first.
struct JoinedPair {
  std::size_t a = 0;
  std::size_t b = 0;
  bool operator==(const JoinedPair&) const = default;
};

struct ChainedPose {
  Pose2 T_i_j;
  PoseVariance variance;
  double cost = 0.0;              ///< Of the variance, 0 to 1; see RelationGraph.
  std::vector<JoinedPair> pairs;  ///< That the chain went through, from i to j.
};

/// The graph whose nodes are the relations' stamps and whose constraints are the relations.
///
/// A chain is a walk from i to j along relations, forwards or backwards. Each adds its noise: to
/// the position of j that of its translation, and that of its rotation times the distance from
/// there to j (the lever); to the heading that of its rotation. The cost of a chain is
///   (sigma_translation / max_translation_sigma)^2 + (sigma_rotation / max_rotation_sigma)^2,
/// and the cheapest chain is found by Dijkstra's algorithm from j backwards, where the levers are
/// known. Chains that cost more than 1 are discarded.
class RelationGraph {
 public:
  explicit RelationGraph(std::span<const Relation> relations,
                         const RelationGraphParams& params = {});

  /// Every stamp of the relations once, earliest first.
  [[nodiscard]] std::span<const Timestamp> stamps() const { return stamps_; }

  /// The node of a stamp, within its rounding (kSameStamp_ns); nothing where there is none.
  [[nodiscard]] std::optional<std::size_t> find(Timestamp stamp) const;

  /// The cheapest chain from a place i to a place j, each reached over one of its ends, that uses
  /// none of the avoided pairs. Nothing where none has a cost of at most 1.
  [[nodiscard]] std::optional<ChainedPose> chain(std::span<const ChainEnd> ends_i,
                                                 std::span<const ChainEnd> ends_j,
                                                 std::span<const JoinedPair> avoided = {}) const;

 private:
  /// A relation, kept at one of its nodes: the other node, and this one seen from there.
  struct Neighbour {
    std::size_t node = 0;
    Pose2 T_node_here;
  };

  /// What is known of the way from a node to j.
  struct Label {
    double cost = 0.0;
    Pose2 T_node_j;
    PoseVariance variance;
    std::size_t next = 0;  ///< The node after this one, on the way to j; itself at the end.
    bool is_settled = false;
  };

  [[nodiscard]] double cost_of(const PoseVariance& variance) const;
  /// The way of `label`, one step longer at its beginning.
  [[nodiscard]] Label prepend(const Pose2& T_before_node,
                              const PoseVariance& step,
                              const Label& label) const;
  [[nodiscard]] std::vector<Label> labels_to(std::span<const ChainEnd> ends_j,
                                             std::span<const JoinedPair> avoided) const;

  RelationGraphParams params_;
  std::vector<Timestamp> stamps_;
  std::vector<std::vector<Neighbour>> neighbours_;
};

}  // namespace setsquare
