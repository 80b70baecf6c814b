// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "setsquare/eval/closure_judgement.hpp"
#include "setsquare/eval/pose_index.hpp"
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

/// What a chain tells, with its noise.
[[nodiscard]] ReferencePose expected_pose(const ChainedPose& chained);

/// Where a robot was at one scan, seen from another, as relations tell it that have neither stamp:
/// from i a short hop along the trajectory to a relation's stamp, a chain of relations, a short hop
/// to j. Nothing of the trajectory but the two hops enters.
class ChainedReference {
 public:
  ChainedReference(std::span<const Relation> relations,
                   const Trajectory& trajectory,
                   const HopParams& hop_params = {},
                   const RelationGraphParams& graph_params = {});

  /// T_i_j by the cheapest chain and by the cheapest of those that share no pair of stamps with it:
  /// none, one or two poses. None, too, where both hops meet at one stamp: no relation told it.
  [[nodiscard]] std::vector<ReferencePose> expected(Timestamp stamp_i, Timestamp stamp_j) const;

 private:
  [[nodiscard]] std::vector<ChainEnd> ends_near(Timestamp stamp) const;

  RelationGraph graph_;
  PoseIndex trajectory_;
  HopParams hop_params_;
};

}  // namespace setsquare
