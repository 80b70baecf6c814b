// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "setsquare/graph/linear_pose_graph.hpp"
#include "setsquare/graph/pose_graph.hpp"

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

  /// Whether two closures tell the same of one part of the track and another, as far as odometry
  /// knows the ways between their ends. Not where it is broken there.
  [[nodiscard]] bool agree(const PositionTerm& a,
                           const PositionTerm& b,
                           double max_squared_error) const;

  /// Length of the track up to a node, in m.
  [[nodiscard]] double way_m(std::size_t node) const { return ways_m_[node]; }

 private:
  /// From one node of a piece to another.
  [[nodiscard]] Eigen::Matrix2d covariance_m2(std::size_t i, std::size_t j) const;

  std::vector<Eigen::Vector2d> positions_m_;     ///< Of node k in the frame of its piece.
  std::vector<Eigen::Matrix2d> covariances_m2_;  ///< Summed up from the piece's first node.
  std::vector<std::size_t> first_of_piece_;
  std::vector<double> ways_m_;
};

/// Closures that are one piece of evidence: nearer to each other than place_m along the track at
/// both ends, or linked by such, and telling the same. Where such a closure is wrong the others
/// are, too, for a place was taken for another; so they are one claim. For each constraint the
/// claim that it is of; those of one claim have the same number. Odometry constraints are alone.
[[nodiscard]] std::vector<std::size_t> claims_of(const PoseGraph& graph,
                                                 const std::vector<PositionTerm>& terms,
                                                 double place_m,
                                                 double max_squared_error);

}  // namespace setsquare
