// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "setsquare/graph/position_system.hpp"

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

}  // namespace setsquare
