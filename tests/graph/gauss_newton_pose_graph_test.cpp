// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "setsquare/core/error.hpp"
#include "setsquare/graph/gauss_newton.hpp"
#include "setsquare/graph/linear_pose_graph.hpp"
#include "setsquare/graph/pose_equations.hpp"
#include "tests/graph/simulated_pose_graph.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::gauss_newton_pose_graph_test {

using testing::make_generator;
using testing::mean_position_error_m;
using testing::PoseNear;
using testing::simulate_pose_graph;
using testing::SimulatedPoseGraph;

void place(PoseGraph& graph) {
  const auto positions_m = solve_positions(graph);
  for (std::size_t node = 0; node < positions_m.size(); ++node) {
    graph.T_map_node[node].x_m = positions_m[node].x();
    graph.T_map_node[node].y_m = positions_m[node].y();
  }
}

double mean_heading_error_rad(const SimulatedPoseGraph& simulated) {
  double sum = 0.0;
  for (std::size_t k = 0; k < simulated.truth.size(); ++k) {
    const double theta_rad = simulated.graph.T_map_node[k].theta_rad;
    sum += std::abs(wrap_to_pi(theta_rad - simulated.truth[k].theta_rad));
  }
  return sum / static_cast<double>(simulated.truth.size());
}

TEST(GaussNewtonPoseGraph, LowersTheCostAndConverges) {
  std::mt19937_64 generator = make_generator();
  SimulatedPoseGraph simulated =
      simulate_pose_graph({.heading_sigma_rad = rad_from_deg(0.5)}, generator);
  place(simulated.graph);
  const double heading_error_rad = mean_heading_error_rad(simulated);
  const double position_error_m = mean_position_error_m(simulated);
  const GaussNewtonSummary summary = polish(simulated.graph);
  EXPECT_LT(summary.num_iterations, 10);
  EXPECT_LT(summary.final_cost, summary.initial_cost);
  EXPECT_NEAR(summary.final_cost, cost(simulated.graph), 1e-9 * summary.final_cost);
  // Twice the cost is chi-squared: 3 residuals per constraint and one per heading measurement, less
  // the unknowns, which are 3 per node but for node 0's position.
  const std::size_t num_nodes = simulated.truth.size();
  const std::size_t num_residuals = 3 * simulated.graph.constraints.size() + num_nodes;
  const auto num_degrees = static_cast<double>(num_residuals - (3 * num_nodes - 2));
  EXPECT_NEAR(2.0 * summary.final_cost / num_degrees, 1.0, 5.0 * std::sqrt(2.0 / num_degrees));
  EXPECT_LT(mean_heading_error_rad(simulated), 0.5 * heading_error_rad);
  EXPECT_LT(mean_position_error_m(simulated), position_error_m);
}

TEST(GaussNewtonPoseGraph, EndsAtAMinimum) {
  std::mt19937_64 generator = make_generator();
  SimulatedPoseGraph simulated =
      simulate_pose_graph({.num_nodes = 120, .num_blocks = 1, .num_closures = 30}, generator);
  place(simulated.graph);
  PoseGraph& graph = simulated.graph;
  polish(graph, {.max_iterations = 50, .converged_m = 1e-9, .converged_rad = 1e-9});
  const double least = cost(graph);
  for (std::size_t node = 1; node < graph.T_map_node.size(); node += 7) {
    for (const double step : {-1e-4, 1e-4}) {
      for (double Pose2::*coordinate : {&Pose2::x_m, &Pose2::y_m, &Pose2::theta_rad}) {
        PoseGraph moved = graph;
        moved.T_map_node[node].*coordinate += step;
        EXPECT_GT(cost(moved), least) << "node " << node;
      }
    }
  }
}

TEST(GaussNewtonPoseGraph, FromFarOffItNeverGetsWorse) {
  std::mt19937_64 generator = make_generator();
  SimulatedPoseGraph simulated = simulate_pose_graph({.num_nodes = 400}, generator);
  for (Pose2& pose : simulated.graph.T_map_node) {
    pose = {testing::uniform(generator, -9.0, 9.0),
            testing::uniform(generator, -9.0, 9.0),
            testing::uniform(generator, -3.0, 3.0)};
  }
  double last = cost(simulated.graph);
  for (int iteration = 0; iteration < 5; ++iteration) {
    const GaussNewtonSummary summary = polish(simulated.graph, {.max_iterations = 1});
    EXPECT_EQ(summary.initial_cost, last);
    EXPECT_LE(summary.final_cost, last);
    last = summary.final_cost;
  }
}

TEST(GaussNewtonPoseGraph, NodeZeroStaysAndTurnsOnlyWhereHeadingsAreMeasured) {
  std::mt19937_64 generator = make_generator();
  SimulatedPoseGraph simulated = simulate_pose_graph({.num_nodes = 400}, generator);
  simulated.graph.T_map_node[0] = {2.0, -1.0, 0.01};
  place(simulated.graph);
  PoseGraph without_headings = simulated.graph;
  without_headings.headings.clear();
  polish(simulated.graph);
  polish(without_headings);
  EXPECT_EQ(simulated.graph.T_map_node[0].translation(), Eigen::Vector2d(2.0, -1.0));
  EXPECT_NE(simulated.graph.T_map_node[0].theta_rad, 0.01);
  EXPECT_EQ(without_headings.T_map_node[0], (Pose2{2.0, -1.0, 0.01}));
}

TEST(GaussNewtonPoseGraph, WeightsCount) {
  PoseGraph graph;
  graph.T_map_node.resize(2);
  for (const double x_m : {1.0, 2.0}) {
    Constraint constraint;
    constraint.to = 1;
    constraint.T_from_to.x_m = x_m;
    constraint.weight = x_m == 2.0 ? 0.25 : 1.0;
    graph.constraints.push_back(constraint);
  }
  polish(graph);
  EXPECT_THAT(graph.T_map_node[1], PoseNear(Pose2{1.2, 0.0, 0.0}, testing::PoseTolerance{}));
}

TEST(GaussNewtonPoseGraph, AnOpenPoseIsAnError) {
  PoseGraph graph;
  graph.T_map_node.resize(3);
  Constraint constraint;
  constraint.to = 1;
  graph.constraints = {constraint};
  EXPECT_THROW(polish(graph), ParameterError);
  constraint.to = 2;
  constraint.information = Eigen::Vector3d(1.0, 1.0, 0.0).asDiagonal();
  graph.constraints.push_back(constraint);
  EXPECT_THROW(polish(graph), ParameterError);
  graph.headings.push_back({.node = 2, .heading_rad = 0.0, .information_per_rad2 = 1.0});
  EXPECT_THROW(polish(graph), ParameterError);  // Now node 0 may turn.
  graph.headings.push_back({.node = 0, .heading_rad = 0.0, .information_per_rad2 = 1.0});
  EXPECT_NO_THROW(polish(graph));
}

TEST(GaussNewtonPoseGraph, AnIslandOfNodesIsAnError) {
  std::mt19937_64 generator = make_generator();
  PoseGraph graph = simulate_pose_graph({.num_nodes = 3000, .num_closures = 0}, generator).graph;
  graph.constraints[1000].weight = 0.0;
  EXPECT_THROW(polish(graph), ParameterError);
}

TEST(GaussNewtonPoseGraph, ParametersAreChecked) {
  PoseGraph graph;
  EXPECT_THROW(polish(graph, {.max_iterations = -1}), ParameterError);
  EXPECT_THROW(polish(graph, {.converged_m = 0.0}), ParameterError);
  EXPECT_THROW(polish(graph, {.converged_rad = 0.0}), ParameterError);
  EXPECT_EQ(polish(graph).num_iterations, 0);  // Nothing to do.
}

}  // namespace setsquare::gauss_newton_pose_graph_test
