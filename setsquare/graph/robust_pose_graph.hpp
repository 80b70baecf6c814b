// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Graduated non-convexity: Yang et al. 2020, "Graduated Non-Convexity for Robust Spatial
// Perception", IEEE RA-L 5.
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "setsquare/graph/linear_pose_graph.hpp"
#include "setsquare/graph/pose_graph.hpp"
#include "setsquare/graph/robust_params.hpp"

namespace setsquare {
/// Where odometry alone says that the nodes are, and how well it knows.
class DeadReckoning {
 public:
  /// By those constraints between a node and the next that are odometry.
  explicit DeadReckoning(const PoseGraph& graph, const std::vector<PositionTerm>& terms);

  /// Squared Mahalanobis length of what a closure says otherwise than odometry, by the covariance
  /// of both: chi-squared, as squared_error(), where the closure and the odometry are right.
  /// Nothing where odometry is broken between the two nodes.
  [[nodiscard]] std::optional<double> squared_disagreement(const PositionTerm& closure) const;

 private:
  std::vector<Eigen::Vector2d> positions_m_;     ///< Of node k in the frame of its piece.
  std::vector<Eigen::Matrix2d> covariances_m2_;  ///< Summed up from the piece's first node.
  std::vector<std::size_t> first_of_piece_;
};

/// Weights of the loop closures and positions of the nodes, headings as they are: truncated least
/// squares by graduated non-convexity, each step one linear solve.
///
/// 1. Graduation from full weights of all closures (a warm start rejects the right closure after a
///    long loop).
/// 2. Where closures were refused: a second graduation, from full weights of those that odometry's
///    own covariance does not exclude; all may join when it ends. Wrong closures that outnumber the
///    right ones can pull the first start where the right ones look wrong.
/// 3. The one with the lower cost stays: sum of the squared errors, closures' truncated at their
///    threshold. So odometry that is worse than its information says does no harm.
///
/// The squared error of a closure is e^T W e: W is the information of its translation given the
/// rotation, and e has the part taken out that a rotation at variance with the headings explains
/// (linear_pose_graph.hpp). The rotation itself is not judged. A caller that trusts a closure's
/// rotation less than the headings passes a W without that coupling.
///
/// `groups`: one entry per constraint; closures of one group are accepted or refused together, by
/// their mean squared error as a share of their thresholds; empty: each stands alone. Odometry
/// constraints keep their weight. A piece of track that odometry does not join to node 0 still gets
/// a position where all closures that join it are refused: the one that they agree upon best.
/// Throws ParameterError where a node is not connected, or a parameter or the graph is not valid.
void solve_robustly(PoseGraph& graph,
                    std::span<const std::size_t> groups = {},
                    const RobustPoseGraphParams& params = {});

}  // namespace setsquare
