// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/gauss_newton.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/core/error.hpp"
#include "setsquare/graph/pose_equations.hpp"

namespace setsquare {
namespace {

constexpr int kMaxHalvings = 6;

std::vector<Pose2> moved(const std::vector<Pose2>& poses, const Eigen::VectorXd& step) {
  std::vector<Pose2> result = poses;
  for (std::size_t node = 0; node < poses.size(); ++node) {
    const auto first = 3 * static_cast<Eigen::Index>(node);
    result[node].x_m += step[first];
    result[node].y_m += step[first + 1];
    result[node].theta_rad = wrap_to_pi(result[node].theta_rad + step[first + 2]);
  }
  return result;
}

bool is_converged(const Eigen::VectorXd& step, const GaussNewtonParams& params) {
  for (Eigen::Index first = 0; first < step.size(); first += 3) {
    if (std::hypot(step[first], step[first + 1]) >= params.converged_m) return false;
    if (std::abs(step[first + 2]) >= params.converged_rad) return false;
  }
  return true;
}

/// Takes the step, halved until the cost falls; the new cost, or the old one where it never does.
double take_step(PoseGraph& graph, Eigen::VectorXd& step, double old_cost) {
  const std::vector<Pose2> before = graph.T_map_node;
  for (int halving = 0; halving <= kMaxHalvings; ++halving) {
    graph.T_map_node = moved(before, step);
    const double new_cost = cost(graph);
    if (new_cost < old_cost) return new_cost;
    step *= 0.5;
  }
  graph.T_map_node = before;
  return old_cost;
}

}  // namespace

void GaussNewtonParams::validate() const {
  if (max_iterations < 0) throw ParameterError("max_iterations", "must not be negative");
  if (!(converged_m > 0.0)) throw ParameterError("converged_m", "must be positive");
  if (!(converged_rad > 0.0)) throw ParameterError("converged_rad", "must be positive");
}

GaussNewtonSummary polish(PoseGraph& graph, const GaussNewtonParams& params) {
  params.validate();
  PoseEquations equations(graph);
  GaussNewtonSummary summary;
  summary.initial_cost = cost(graph);
  summary.final_cost = summary.initial_cost;
  if (graph.T_map_node.empty()) return summary;
  while (summary.num_iterations < params.max_iterations) {
    equations.linearize(graph);
    Eigen::VectorXd step = equations.step();
    const double new_cost = take_step(graph, step, summary.final_cost);
    ++summary.num_iterations;
    const bool is_lower = new_cost < summary.final_cost;
    summary.final_cost = new_cost;
    if (!is_lower || is_converged(step, params)) break;
  }
  return summary;
}

}  // namespace setsquare
