// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/linear_pose_graph.hpp"

#include "setsquare/graph/position_system.hpp"

namespace setsquare {

std::vector<Eigen::Vector2d> solve_positions(const PoseGraph& graph) {
  PositionSystem system(graph);
  if (graph.T_map_node.empty()) return {};
  std::vector<double> weights;
  weights.reserve(graph.constraints.size());
  for (const Constraint& constraint : graph.constraints) weights.push_back(constraint.weight);
  std::vector<Eigen::Vector2d> positions_m(graph.T_map_node.size(),
                                           graph.T_map_node[0].translation());
  system.solve(weights, positions_m);
  system.solve(weights, positions_m);  // Takes out what rounding of the first has left.
  return positions_m;
}

}  // namespace setsquare
