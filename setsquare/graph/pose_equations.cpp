// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/pose_equations.hpp"

#include <cmath>

#include "setsquare/core/error.hpp"
#include "setsquare/graph/node_sets.hpp"

namespace setsquare {
namespace {

/// Share of a diagonal entry below which its pivot is rounding alone.
constexpr double kSingularPivot = 1e-14;

/// An empty system of the graph's pattern; throws where the graph is not valid.
BlockEquations<3> equations_of(const PoseGraph& graph) {
  validate(graph);
  std::vector<BlockEquations<3>::Pair> pairs;
  pairs.reserve(graph.constraints.size());
  for (const Constraint& constraint : graph.constraints) {
    pairs.emplace_back(constraint.from, constraint.to);
  }
  return {graph.T_map_node.size(), pairs};
}

bool has_heading(const PoseGraph& graph) {
  for (const HeadingMeasurement& heading : graph.headings) {
    if (heading.information_per_rad2 > 0.0) return true;
  }
  return false;
}

/// Whether all nodes are connected, however weakly. Pivots alone do not show it: in a large graph
/// the rounding of a pivot that should vanish can look like a constraint.
bool is_one_piece(const PoseGraph& graph) {
  NodeSets sets(graph.T_map_node.size());
  for (const Constraint& constraint : graph.constraints) {
    if (constraint.weight * constraint.information.trace() <= 0.0) continue;
    sets.join(constraint.from, constraint.to);
  }
  return sets.num_sets() <= 1;
}

double heading_residual(const PoseGraph& graph, const HeadingMeasurement& heading) {
  return wrap_to_pi(graph.T_map_node[heading.node].theta_rad - heading.heading_rad);
}

}  // namespace

ResidualJacobians residual_jacobians(const PoseGraph& graph, const Constraint& constraint) {
  const Pose2& from = graph.T_map_node[constraint.from];
  const Pose2& to = graph.T_map_node[constraint.to];
  const double c = std::cos(from.theta_rad);
  const double s = std::sin(from.theta_rad);
  // R^T of `from`, and its derivative by theta times the distance.
  const Eigen::Vector2d d = to.translation() - from.translation();
  ResidualJacobians jacobians;
  jacobians.to << c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0;
  jacobians.from = -jacobians.to;
  jacobians.from(0, 2) = -s * d.x() + c * d.y();
  jacobians.from(1, 2) = -c * d.x() - s * d.y();
  return jacobians;
}

double cost(const PoseGraph& graph) {
  double sum = 0.0;
  for (const Constraint& constraint : graph.constraints) {
    sum += constraint.weight * squared_error(graph, constraint);
  }
  for (const HeadingMeasurement& heading : graph.headings) {
    const double r = heading_residual(graph, heading);
    sum += heading.information_per_rad2 * r * r;
  }
  return 0.5 * sum;
}

PoseEquations::PoseEquations(const PoseGraph& graph)
    : equations_(equations_of(graph)), is_heading_held_(!has_heading(graph)) {}

void PoseEquations::add(const PoseGraph& graph, std::size_t k) {
  const Constraint& constraint = graph.constraints[k];
  auto [J_from, J_to] = residual_jacobians(graph, constraint);
  const int num_held = is_heading_held_ ? 3 : 2;
  if (constraint.from == 0) J_from.leftCols(num_held).setZero();
  if (constraint.to == 0) J_to.leftCols(num_held).setZero();
  const Eigen::Matrix3d Omega = constraint.weight * constraint.information;
  const Eigen::Vector3d r = residual(graph, constraint);
  const Eigen::Matrix3d from_Omega = J_from.transpose() * Omega;
  const Eigen::Matrix3d to_Omega = J_to.transpose() * Omega;
  equations_.add_diagonal(constraint.from, from_Omega * J_from);
  equations_.add_diagonal(constraint.to, to_Omega * J_to);
  equations_.add_pair(k, from_Omega * J_to);
  equations_.add_to_b(constraint.from, -(from_Omega * r));
  equations_.add_to_b(constraint.to, -(to_Omega * r));
}

void PoseEquations::linearize(const PoseGraph& graph) {
  equations_.set_zero();
  if (graph.T_map_node.empty()) return;
  if (!is_one_piece(graph)) throw ParameterError("constraints", "leave nodes without a hold");
  const double heading_holds = is_heading_held_ ? 1.0 : 0.0;
  equations_.add_diagonal(0, Eigen::Vector3d(1.0, 1.0, heading_holds).asDiagonal());
  for (std::size_t k = 0; k < graph.constraints.size(); ++k) add(graph, k);
  for (const HeadingMeasurement& heading : graph.headings) {
    const double information = heading.information_per_rad2;
    const Eigen::Vector3d held(0.0, 0.0, information);
    equations_.add_diagonal(heading.node, held.asDiagonal());
    equations_.add_to_b(heading.node, -held * heading_residual(graph, heading));
  }
  if (!(equations_.factor() > kSingularPivot)) {
    throw ParameterError("constraints", "leave the pose of a node open");
  }
}

}  // namespace setsquare
