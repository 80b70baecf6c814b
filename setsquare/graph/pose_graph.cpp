// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/pose_graph.hpp"

#include <cmath>
#include <string>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

bool is_finite(const Pose2& pose) {
  return std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.theta_rad);
}

/// What is wrong with a constraint; empty where nothing is.
std::string fault_of(const Constraint& constraint, std::size_t num_nodes) {
  if (constraint.from >= num_nodes || constraint.to >= num_nodes) return "names no node";
  if (constraint.from == constraint.to) return "must join two nodes";
  if (!is_finite(constraint.T_from_to)) return "has a pose that is not finite";
  if (!constraint.information.allFinite()) return "has information that is not finite";
  if (!(constraint.weight >= 0.0 && constraint.weight <= 1.0)) return "has a weight beyond 0 to 1";
  if (constraint.information.diagonal().minCoeff() < 0.0) return "has negative information";
  return {};
}

/// What is wrong with a heading measurement; empty where nothing is.
std::string fault_of(const HeadingMeasurement& heading, std::size_t num_nodes) {
  if (heading.node >= num_nodes) return "names no node";
  if (!std::isfinite(heading.heading_rad)) return "is not finite";
  if (!std::isfinite(heading.information_per_rad2)) return "has information that is not finite";
  if (heading.information_per_rad2 < 0.0) return "has negative information";
  return {};
}

/// Throws where one of the measurements has a fault.
template <typename Measurements>
void require_no_fault(const Measurements& measurements, std::size_t num_nodes, const char* name) {
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    const std::string fault = fault_of(measurements[k], num_nodes);
    if (!fault.empty()) throw ParameterError(name + ("[" + std::to_string(k) + "]"), fault);
  }
}

}  // namespace

Eigen::Vector3d residual(const PoseGraph& graph, const Constraint& constraint) {
  const Pose2 T_from_to =
      graph.T_map_node[constraint.from].inverse() * graph.T_map_node[constraint.to];
  return {T_from_to.x_m - constraint.T_from_to.x_m,
          T_from_to.y_m - constraint.T_from_to.y_m,
          wrap_to_pi(T_from_to.theta_rad - constraint.T_from_to.theta_rad)};
}

double squared_error(const PoseGraph& graph, const Constraint& constraint) {
  const Eigen::Vector3d r = residual(graph, constraint);
  return r.dot(constraint.information * r);
}

void validate(const PoseGraph& graph) {
  const std::size_t num_nodes = graph.T_map_node.size();
  for (std::size_t node = 0; node < num_nodes; ++node) {
    if (is_finite(graph.T_map_node[node])) continue;
    throw ParameterError("T_map_node[" + std::to_string(node) + "]", "is not finite");
  }
  require_no_fault(graph.constraints, num_nodes, "constraints");
  require_no_fault(graph.headings, num_nodes, "headings");
}

}  // namespace setsquare
