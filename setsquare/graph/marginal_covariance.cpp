// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/marginal_covariance.hpp"

#include <array>
#include <cassert>
#include <span>
#include <vector>

#include "setsquare/graph/pose_equations.hpp"

namespace setsquare {

struct MarginalCovariance::Factor {
  explicit Factor(const PoseGraph& graph_in) : graph(graph_in), equations(graph_in) {
    equations.linearize(graph);
  }

  PoseGraph graph;
  PoseEquations equations;

  /// Joint covariance of the nodes' poses, 3 rows and columns each: those of H^-1. The held part of
  /// node 0 has no covariance.
  [[nodiscard]] Eigen::MatrixXd joint(std::span<const std::size_t> nodes) const {
    const auto num = static_cast<Eigen::Index>(nodes.size());
    std::vector<BlockRows> unit;
    for (Eigen::Index k = 0; k < num; ++k) {
      unit.push_back({nodes[k], Eigen::MatrixXd::Zero(3, 3 * num)});
      Eigen::Vector3d free = Eigen::Vector3d::Ones();
      if (nodes[k] == 0) free = {0.0, 0.0, equations.is_heading_held() ? 0.0 : 1.0};
      unit.back().values.middleCols<3>(3 * k) = free.asDiagonal();
    }
    return equations.inverse_form(unit);
  }

  /// Of the difference of two positions: J H^-1 J^T. Node 0 has no part: its position is held.
  [[nodiscard]] Eigen::Matrix2d way(std::size_t from, std::size_t to) const {
    std::vector<BlockRows> J_transposed;
    if (to != from && to != 0) J_transposed.push_back({to, Eigen::MatrixXd::Identity(3, 2)});
    if (to != from && from != 0) J_transposed.push_back({from, -Eigen::MatrixXd::Identity(3, 2)});
    if (J_transposed.empty()) return Eigen::Matrix2d::Zero();
    return equations.inverse_form(J_transposed);
  }

  [[nodiscard]] double heading(std::size_t node) const {
    if (node == 0 && equations.is_heading_held()) return 0.0;
    const BlockRows unit{node, Eigen::Vector3d::UnitZ()};
    return equations.inverse_form({&unit, 1})(0, 0);
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
