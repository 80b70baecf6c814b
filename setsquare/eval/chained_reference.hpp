// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/eval/closure_judgement.hpp"
#include "setsquare/eval/error_statistics.hpp"
#include "setsquare/eval/pose_pairs.hpp"
#include "setsquare/eval/relation_graph.hpp"

namespace setsquare {
/// How far a trajectory is trusted between a scan and the stamp of a relation nearby: it is right
/// to a centimetre over seconds, whatever it does over minutes.
struct HopParams {
  double max_time_s = 5.0;
  double max_distance_m = 2.0;
  double max_rotation_rad = rad_from_deg(30.0);
  double translation_sigma_m = 0.015;              ///< Of a hop, along either axis.
  double rotation_sigma_rad = rad_from_deg(0.25);  ///< Of a hop.

  /// Throws ParameterError naming the first field that is not positive and finite.
  void validate() const;
};

/// The relative pose along a chain, with its noise.
[[nodiscard]] ReferencePose expected_pose(const ChainedPose& chained);

/// Relative pose of two scans, from relations that contain neither stamp: a short hop along the
/// trajectory from i to a relation's stamp, a chain of relations, a short hop to j. Only the two
/// hops use the trajectory.
class ChainedReference {
 public:
  ChainedReference(std::span<const Relation> relations,
                   const Trajectory& trajectory,
                   const HopParams& hop_params = {},
                   const RelationGraphParams& graph_params = {});

  /// T_i_j by the cheapest chain and by the cheapest of those that share no pair of stamps with it:
  /// none, one or two poses. None, too, where both hops meet at one stamp: no relation measured it.
  [[nodiscard]] std::vector<ReferencePose> expected(Timestamp stamp_i, Timestamp stamp_j) const;

 private:
  [[nodiscard]] std::vector<ChainEnd> ends_near(Timestamp stamp) const;

  RelationGraph graph_;
  PoseIndex trajectory_;
  HopParams hop_params_;
};

struct ChainCheckParams {
  double min_time_s = 60.0;  ///< Relations between stamps less far apart are not checked.
  ClosureLimits limits;
  RelationGraphParams graph;
};

/// How well chains of relations predict relations that are not in them.
struct ChainCheck {
  std::size_t num_relations = 0;  ///< Long enough to be checked.
  /// As closures; unjudged are those that the others do not chain to. A right relation that is
  /// judged wrong is an error of the judgement.
  ClosureCounts verdicts;
  ErrorStatistics translation_m;  ///< Of the cheapest chains.
  ErrorStatistics rotation_rad;
};

/// Leaves out each relation in turn (and all others between the same two stamps), and judges it by
/// the chains of the rest as if it were a closure. It shows how reliable the verdicts on closures
/// are.
[[nodiscard]] ChainCheck check_chains(std::span<const Relation> relations,
                                      const ChainCheckParams& params = {});

}  // namespace setsquare
