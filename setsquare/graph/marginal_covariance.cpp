// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/marginal_covariance.hpp"

#include <array>
#include <cassert>
#include <span>

#include "setsquare/graph/pose_equations.hpp"

namespace setsquare {

struct MarginalCovariance::Factor {
  explicit Factor(const PoseGraph& graph_in) : graph(graph_in), equations(graph_in) {
    equations.linearize(graph);
  }

  PoseGraph graph;
  PoseEquations equations;

  /// Joint covariance of the nodes' poses, 3 rows and columns each: those of H^-1, for which one
  /// unit column per unknown is solved. The held part of node 0 has no covariance.
  [[nodiscard]] Eigen::MatrixXd joint(std::span<const std::size_t> nodes) const {
    const auto n = static_cast<Eigen::Index>(nodes.size());
    const auto num_unknowns = 3 * static_cast<Eigen::Index>(graph.T_map_node.size());
    Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(num_unknowns, 3 * n);
    for (Eigen::Index k = 0; k < n; ++k) {
      const auto first = 3 * static_cast<Eigen::Index>(nodes[k]);
      unit.block<3, 3>(first, 3 * k).setIdentity();
      if (nodes[k] != 0) continue;
      unit.block<2, 2>(first, 3 * k).setZero();
      if (equations.is_heading_held()) unit(first + 2, 3 * k + 2) = 0.0;
    }
    const Eigen::MatrixXd columns = equations.solve(unit);
    Eigen::MatrixXd result(3 * n, 3 * n);
    for (Eigen::Index k = 0; k < n; ++k) {
      result.middleRows<3>(3 * k) = columns.middleRows<3>(3 * static_cast<Eigen::Index>(nodes[k]));
    }
    return 0.5 * (result + result.transpose());
  }

  /// Of the difference of two positions: J H^-1 J^T, for which J's two rows are solved. Node 0 has
  /// no part: its position is held.
  [[nodiscard]] Eigen::Matrix2d way(std::size_t from, std::size_t to) const {
    const auto num_unknowns = 3 * static_cast<Eigen::Index>(graph.T_map_node.size());
    const auto first = [](std::size_t node) { return 3 * static_cast<Eigen::Index>(node); };
    Eigen::MatrixXd J_transposed = Eigen::MatrixXd::Zero(num_unknowns, 2);
    if (to != 0) J_transposed.block<2, 2>(first(to), 0).diagonal().array() += 1.0;
    if (from != 0) J_transposed.block<2, 2>(first(from), 0).diagonal().array() -= 1.0;
    const Eigen::MatrixXd columns = equations.solve(J_transposed);
    Eigen::Matrix2d result = Eigen::Matrix2d::Zero();
    if (to != 0) result += columns.block<2, 2>(first(to), 0);
    if (from != 0) result -= columns.block<2, 2>(first(from), 0);
    return 0.5 * (result + result.transpose());
  }

  [[nodiscard]] double heading(std::size_t node) const {
    if (node == 0 && equations.is_heading_held()) return 0.0;
    const auto row = 3 * static_cast<Eigen::Index>(node) + 2;
    Eigen::MatrixXd unit =
        Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(graph.T_map_node.size()), 1);
    unit(row, 0) = 1.0;
    return equations.solve(unit)(row, 0);
  }
};

MarginalCovariance::MarginalCovariance(const PoseGraph& graph)
    : factor_(std::make_unique<Factor>(graph)) {}

MarginalCovariance::~MarginalCovariance() = default;
MarginalCovariance::MarginalCovariance(MarginalCovariance&&) noexcept = default;
MarginalCovariance& MarginalCovariance::operator=(MarginalCovariance&&) noexcept = default;

Eigen::Matrix3d MarginalCovariance::of(std::size_t node) const {
  assert(node < factor_->graph.T_map_node.size());
  return factor_->joint(std::array{node});
}

Eigen::Matrix3d MarginalCovariance::between(std::size_t from, std::size_t to) const {
  assert(from < factor_->graph.T_map_node.size());
  assert(to < factor_->graph.T_map_node.size());
  if (from == to) return Eigen::Matrix3d::Zero();
  // The relative pose is the residual of a constraint that measured nothing.
  Constraint unmeasured;
  unmeasured.from = from;
  unmeasured.to = to;
  const auto [J_from, J_to] = residual_jacobians(factor_->graph, unmeasured);
  Eigen::Matrix<double, 3, 6> J;
  J << J_from, J_to;
  return J * factor_->joint(std::array{from, to}) * J.transpose();
}

Eigen::Matrix2d MarginalCovariance::of_way(std::size_t from, std::size_t to) const {
  assert(from < factor_->graph.T_map_node.size());
  assert(to < factor_->graph.T_map_node.size());
  return factor_->way(from, to);
}

double MarginalCovariance::of_heading(std::size_t node) const {
  assert(node < factor_->graph.T_map_node.size());
  return factor_->heading(node);
}

}  // namespace setsquare
