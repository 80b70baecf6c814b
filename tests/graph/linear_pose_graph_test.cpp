// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/linear_pose_graph.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "setsquare/core/error.hpp"
#include "setsquare/graph/gauss_newton.hpp"
#include "tests/graph/simulated_pose_graph.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::linear_pose_graph_test {

using testing::make_generator;
using testing::PoseGraphSimulation;
using testing::simulate_pose_graph;
using testing::SimulatedPoseGraph;

constexpr auto kClosure = ConstraintKind::kLoopClosure;

void place(PoseGraph& graph, const std::vector<Eigen::Vector2d>& positions_m) {
  for (std::size_t node = 0; node < positions_m.size(); ++node) {
    graph.T_map_node[node].x_m = positions_m[node].x();
    graph.T_map_node[node].y_m = positions_m[node].y();
  }
}

double farthest_m(const std::vector<Eigen::Vector2d>& a, const std::vector<Eigen::Vector2d>& b) {
  double farthest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) farthest = std::max(farthest, (a[k] - b[k]).norm());
  return farthest;
}

/// The plain twin: residual() is affine in the positions, so that its dense normal equations at any
/// positions give the minimum in one step; the Jacobian by differences of one metre is exact.
std::vector<Eigen::Vector2d> solve_densely(PoseGraph graph) {
  const auto n = static_cast<Eigen::Index>(graph.T_map_node.size());
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(2 * n);
  for (const Constraint& constraint : graph.constraints) {
    const Eigen::Vector3d r = residual(graph, constraint);
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(3, 2 * n);
    for (const std::size_t node : {constraint.from, constraint.to}) {
      for (int axis = 0; axis < 2; ++axis) {
        PoseGraph moved = graph;
        (axis == 0 ? moved.T_map_node[node].x_m : moved.T_map_node[node].y_m) += 1.0;
        J.col(2 * static_cast<Eigen::Index>(node) + axis) = residual(moved, constraint) - r;
      }
    }
    const Eigen::Matrix3d Omega = constraint.weight * constraint.information;
    H += J.transpose() * Omega * J;
    b -= J.transpose() * Omega * r;
  }
  const Eigen::VectorXd step =
      H.bottomRightCorner(2 * n - 2, 2 * n - 2).ldlt().solve(b.tail(2 * n - 2));
  std::vector<Eigen::Vector2d> positions_m{graph.T_map_node[0].translation()};
  for (Eigen::Index node = 1; node < n; ++node) {
    positions_m.push_back(graph.T_map_node[static_cast<std::size_t>(node)].translation() +
                          step.segment<2>(2 * node - 2));
  }
  return positions_m;
}

/// Three nodes in a row, a metre apart, node 2 seen from node 0, too.
PoseGraph three_nodes() {
  PoseGraph graph;
  graph.T_map_node.resize(3);
  for (const auto& [from, to] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 2}, {0, 2}}) {
    Constraint constraint;
    constraint.from = from;
    constraint.to = to;
    constraint.T_from_to.x_m = static_cast<double>(to - from);
    graph.constraints.push_back(constraint);
  }
  graph.constraints[2].kind = kClosure;
  return graph;
}

TEST(LinearPoseGraph, ExactConstraintsGiveTheTruthAndGaussNewtonAgrees) {
  std::mt19937_64 generator = make_generator();
  for (const std::size_t num_nodes : {2U, 30U, 700U}) {
    PoseGraphSimulation simulation{.num_nodes = num_nodes, .noise = 0.0};
    if (num_nodes < 100) simulation.num_closures = 0;
    SimulatedPoseGraph simulated = simulate_pose_graph(simulation, generator);
    place(simulated.graph, solve_positions(simulated.graph));
    EXPECT_LT(testing::mean_position_error_m(simulated), 1e-9);
    PoseGraph polished = simulated.graph;
    polish(polished);
    for (std::size_t k = 0; k < num_nodes; ++k) {
      ASSERT_THAT(polished.T_map_node[k],
                  testing::PoseNear(simulated.truth[k], testing::PoseTolerance{}));
    }
  }
}

TEST(LinearPoseGraph, IsTheDenseSolution) {
  std::mt19937_64 generator = make_generator();
  SimulatedPoseGraph simulated =
      simulate_pose_graph({.num_nodes = 150, .num_blocks = 1, .num_closures = 40}, generator);
  for (Constraint& constraint : simulated.graph.constraints) {
    constraint.weight = testing::uniform(generator, 0.1, 1.0);
  }
  simulated.graph.T_map_node[0] = {3.0, -7.0, 0.4};
  EXPECT_LT(farthest_m(solve_positions(simulated.graph), solve_densely(simulated.graph)), 1e-9);
}

TEST(LinearPoseGraph, OldPositionsDoNotMatter) {
  std::mt19937_64 generator = make_generator();
  SimulatedPoseGraph simulated = simulate_pose_graph({}, generator);
  const auto positions_m = solve_positions(simulated.graph);
  for (std::size_t k = 1; k < simulated.truth.size(); ++k) {
    simulated.graph.T_map_node[k].x_m = testing::uniform(generator, -1e3, 1e3);
  }
  EXPECT_EQ(farthest_m(solve_positions(simulated.graph), positions_m), 0.0);
}

TEST(LinearPoseGraph, ARotationThatTheHeadingsDenyPullsTheTranslation) {
  PoseGraph graph = three_nodes();
  graph.T_map_node.resize(2);
  graph.constraints.resize(1);
  // Turned about a point 2 m ahead: theta too large by 0.1 comes with y too small by 0.2.
  Eigen::Vector3d lever(0.0, 1.0, 2.0);
  graph.constraints[0].information = Eigen::Vector3d(1.0, 0.0, 0.01).asDiagonal();
  graph.constraints[0].information += 100.0 * lever * lever.transpose();
  graph.constraints[0].T_from_to = {1.0, -0.2, 0.1};
  const auto positions_m = solve_positions(graph);
  EXPECT_NEAR(positions_m[1].x(), 1.0, 1e-12);
  EXPECT_NEAR(positions_m[1].y(), 0.0, 1e-12);
}

TEST(LinearPoseGraph, AConstraintOfOneAxisLeavesTheOtherAlone) {
  PoseGraph graph = three_nodes();
  graph.constraints[2].T_from_to = {2.5, 5.0, 0.0};
  for (const double heading_rad : {0.0, 0.7}) {
    for (Pose2& pose : graph.T_map_node) pose.theta_rad = heading_rad;
    graph.constraints[2].information = Eigen::Vector3d(100.0, 0.0, 1.0).asDiagonal();
    const auto positions_m = solve_positions(graph);
    const Eigen::Vector2d along(std::cos(heading_rad), std::sin(heading_rad));
    const Eigen::Vector2d across(-along.y(), along.x());
    EXPECT_NEAR(across.dot(positions_m[2]), 0.0, 1e-12);
    EXPECT_NEAR(along.dot(positions_m[2]), (1.0 * 2.0 / 2 + 100.0 * 2.5) / 100.5, 1e-9);
    EXPECT_NEAR(along.dot(positions_m[1]), 0.5 * along.dot(positions_m[2]), 1e-9);
  }
}

TEST(LinearPoseGraph, AxesApartAreAxesTogether) {
  std::mt19937_64 generator = make_generator();
  SimulatedPoseGraph simulated = simulate_pose_graph({.num_nodes = 400}, generator);
  for (Pose2& pose : simulated.graph.T_map_node) pose.theta_rad = 0.0;
  for (Constraint& constraint : simulated.graph.constraints) {
    constraint.information(0, 1) = constraint.information(1, 0) = 0.0;
  }
  ASSERT_TRUE(PositionSystem(simulated.graph).is_separable());
  const auto apart = solve_positions(simulated.graph);
  // A coupling that is hardly there makes them be solved together.
  Eigen::Matrix3d& information = simulated.graph.constraints[5].information;
  information(0, 1) = information(1, 0) = 1e-11 * information(0, 0);
  ASSERT_FALSE(PositionSystem(simulated.graph).is_separable());
  EXPECT_LT(farthest_m(solve_positions(simulated.graph), apart), 1e-8);
}

TEST(LinearPoseGraph, NodesBoundByOneAxisEachOfTwoConstraints) {
  PoseGraph graph = three_nodes();
  graph.constraints[1].information = Eigen::Vector3d(1.0, 0.0, 1.0).asDiagonal();
  graph.constraints[2].information = Eigen::Vector3d(0.0, 1.0, 1.0).asDiagonal();
  for (const double heading_rad : {0.0, 0.7}) {  // Apart, together.
    for (Pose2& pose : graph.T_map_node) pose.theta_rad = heading_rad;
    EXPECT_NEAR(solve_positions(graph)[2].norm(), 2.0, 1e-9);
  }
}

TEST(LinearPoseGraph, ANodeThatIsNotConnectedIsAnError) {
  for (const double heading_rad : {0.0, 0.7}) {
    PoseGraph graph = three_nodes();
    for (Pose2& pose : graph.T_map_node) pose.theta_rad = heading_rad;
    graph.constraints.resize(2);
    EXPECT_NO_THROW(static_cast<void>(solve_positions(graph)));
    PoseGraph one_axis = graph;
    one_axis.constraints[1].information = Eigen::Vector3d(1.0, 0.0, 1.0).asDiagonal();
    EXPECT_THROW(static_cast<void>(solve_positions(one_axis)), ParameterError);
    PoseGraph without_weight = graph;
    without_weight.constraints[0].weight = 0.0;
    EXPECT_THROW(static_cast<void>(solve_positions(without_weight)), ParameterError);
    graph.constraints.resize(1);
    EXPECT_THROW(static_cast<void>(solve_positions(graph)), ParameterError);
  }
}

TEST(LinearPoseGraph, AnIslandOfNodesIsAnError) {
  std::mt19937_64 generator = make_generator();
  for (const std::size_t num_nodes : {300U, 10000U}) {
    PoseGraph graph =
        simulate_pose_graph({.num_nodes = num_nodes, .num_closures = 0}, generator).graph;
    ASSERT_EQ(graph.constraints[149].from, 149U);
    graph.constraints.erase(graph.constraints.begin() + 149);
    EXPECT_THROW(static_cast<void>(solve_positions(graph)), ParameterError);
  }
}

TEST(LinearPoseGraph, AWeakLinkOfALongChainIsEnough) {
  std::mt19937_64 generator = make_generator();
  SimulatedPoseGraph simulated =
      simulate_pose_graph({.num_nodes = 5000, .num_closures = 0, .noise = 0.0}, generator);
  simulated.graph.constraints[2500].information *= 1e-8;
  place(simulated.graph, solve_positions(simulated.graph));
  EXPECT_LT(testing::mean_position_error_m(simulated), 1e-6);
}

TEST(LinearPoseGraph, OneNodeAndNone) {
  PoseGraph graph;
  EXPECT_TRUE(solve_positions(graph).empty());
  graph.T_map_node.push_back({1.0, 2.0, 3.0});
  EXPECT_EQ(solve_positions(graph).front(), Eigen::Vector2d(1.0, 2.0));
}

}  // namespace setsquare::linear_pose_graph_test
