// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "setsquare/graph/block_equations.hpp"
#include "setsquare/graph/pose_graph.hpp"

namespace setsquare {

/// A constraint's residual by the nodes' poses, both in the map frame: 3x3 each.
struct ResidualJacobians {
  Eigen::Matrix3d from;
  Eigen::Matrix3d to;
};

/// Of residual(), by (x, y, theta) of the two nodes.
[[nodiscard]] ResidualJacobians residual_jacobians(const PoseGraph& graph,
                                                   const Constraint& constraint);

/// Half the sum of all weighted squared errors, headings included.
[[nodiscard]] double cost(const PoseGraph& graph);

/// The Gauss-Newton equations of all poses (x, y, theta in the map frame). What of node 0 is held
/// has a separate equation, 1 x = 0, coupled with nothing.
class PoseEquations {
 public:
  /// For a graph that validate() accepts; throws as it does.
  explicit PoseEquations(const PoseGraph& graph);

  /// Whether node 0's heading is held with its position: where no heading is measured.
  [[nodiscard]] bool is_heading_held() const { return is_heading_held_; }

  /// Sets up H and b at the poses as they are and factors H; the same graph but for its poses and
  /// weights. Throws ParameterError where a pose is left open.
  void linearize(const PoseGraph& graph);

  /// The step to the minimum of the linearized problem: 3 numbers per node. Needs at least one
  /// node.
  [[nodiscard]] Eigen::VectorXd step() const { return equations_.solve(equations_.b); }

  /// C^T H^-1 C, as BlockEquations has it.
  [[nodiscard]] Eigen::MatrixXd inverse_form(std::span<const BlockRows> rows) const {
    return equations_.inverse_form(rows);
  }

 private:
  void add(const PoseGraph& graph, std::size_t k);

  BlockEquations<3> equations_;
  bool is_heading_held_ = true;
};

}  // namespace setsquare
