// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/marginal_covariance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "setsquare/core/error.hpp"
#include "setsquare/graph/gauss_newton.hpp"
#include "tests/graph/simulated_pose_graph.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::marginal_covariance_test {

using testing::make_generator;
using testing::PoseGraphSimulation;
using testing::simulate_pose_graph;
using testing::SimulatedPoseGraph;

Eigen::Vector3d difference(const Pose2& a, const Pose2& b) {
  return {a.x_m - b.x_m, a.y_m - b.y_m, wrap_to_pi(a.theta_rad - b.theta_rad)};
}

/// The plain twin: the full joint covariance by a dense inverse; Jacobians by differences.
Eigen::MatrixXd dense_covariance(const PoseGraph& graph) {
  constexpr double kStep = 1e-6;
  const auto n = 3 * static_cast<Eigen::Index>(graph.T_map_node.size());
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(n, n);
  for (const Constraint& constraint : graph.constraints) {
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(3, n);
    for (const std::size_t node : {constraint.from, constraint.to}) {
      int column = 3 * static_cast<int>(node);
      for (double Pose2::*coordinate : {&Pose2::x_m, &Pose2::y_m, &Pose2::theta_rad}) {
        PoseGraph moved = graph;
        moved.T_map_node[node].*coordinate += kStep;
        const Eigen::Vector3d ahead = residual(moved, constraint);
        moved.T_map_node[node].*coordinate -= 2.0 * kStep;
        J.col(column++) = (ahead - residual(moved, constraint)) / (2.0 * kStep);
      }
    }
    H += constraint.weight * J.transpose() * constraint.information * J;
  }
  for (const HeadingMeasurement& heading : graph.headings) {
    const auto k = 3 * static_cast<Eigen::Index>(heading.node) + 2;
    H(k, k) += heading.information_per_rad2;
  }
  const Eigen::Index num_held = graph.headings.empty() ? 3 : 2;
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
  covariance.bottomRightCorner(n - num_held, n - num_held) =
      H.bottomRightCorner(n - num_held, n - num_held).inverse();
  return covariance;
}

SimulatedPoseGraph small_graph(std::mt19937_64& generator) {
  SimulatedPoseGraph simulated =
      simulate_pose_graph({.num_nodes = 130, .num_blocks = 1, .num_closures = 20}, generator);
  for (std::size_t k = 0; k < simulated.truth.size(); ++k) {
    simulated.graph.T_map_node[k] = simulated.truth[k];
  }
  simulated.graph.constraints[3].weight = 0.4;
  return simulated;
}

TEST(MarginalCovariance, IsThatOfTheDenseInverse) {
  std::mt19937_64 generator = make_generator();
  PoseGraph graph = small_graph(generator).graph;
  for (const bool has_headings : {true, false}) {
    if (!has_headings) graph.headings.clear();
    const Eigen::MatrixXd expected = dense_covariance(graph);
    const MarginalCovariance covariance(graph);
    for (std::size_t node = 0; node < graph.T_map_node.size(); node += 3) {
      const auto first = 3 * static_cast<Eigen::Index>(node);
      const Eigen::Matrix3d block = expected.block<3, 3>(first, first);
      EXPECT_LE((covariance.of(node) - block).norm(), 1e-6 * block.norm()) << "node " << node;
      EXPECT_NEAR(covariance.of_heading(node), block(2, 2), 1e-6 * block(2, 2)) << "node " << node;
    }
  }
}

TEST(MarginalCovariance, NodeZeroIsCertain) {
  std::mt19937_64 generator = make_generator();
  PoseGraph graph = small_graph(generator).graph;
  const Eigen::Matrix3d turning = MarginalCovariance(graph).of(0);
  EXPECT_GT(turning(2, 2), 0.0);
  EXPECT_EQ(turning.topRows<2>().norm(), 0.0);
  graph.headings.clear();
  EXPECT_EQ(MarginalCovariance(graph).of(0).norm(), 0.0);
}

TEST(MarginalCovariance, BetweenTwoNodes) {
  std::mt19937_64 generator = make_generator();
  PoseGraph graph = small_graph(generator).graph;
  graph.headings.clear();
  const MarginalCovariance covariance(graph);
  EXPECT_EQ(covariance.between(7, 7).norm(), 0.0);
  // Seen from node 0, which is certain, in its own frame: the map frame.
  ASSERT_EQ(graph.T_map_node[0], Pose2{});
  EXPECT_LT((covariance.between(0, 60) - covariance.of(60)).norm(),
            1e-9 * covariance.of(60).norm());
  // A chain's end seen from the node before is as certain as its own step alone.
  PoseGraph chain = graph;
  chain.constraints.resize(graph.T_map_node.size() - 1);
  const Eigen::Matrix3d step = chain.constraints[99].information.inverse();
  EXPECT_LT((MarginalCovariance(chain).between(99, 100) - step).norm(), 1e-6 * step.norm());
  EXPECT_GT(MarginalCovariance(chain).of(100).trace(), 10.0 * step.trace());
}

TEST(MarginalCovariance, OfTheWayIsThatOfTheDenseInverse) {
  std::mt19937_64 generator = make_generator();
  PoseGraph graph = small_graph(generator).graph;
  for (const bool has_headings : {true, false}) {
    if (!has_headings) graph.headings.clear();
    const Eigen::MatrixXd dense = dense_covariance(graph);
    const MarginalCovariance covariance(graph);
    for (const std::size_t from : {0U, 1U, 40U}) {
      for (std::size_t to = 0; to < graph.T_map_node.size(); to += 9) {
        Eigen::MatrixXd J = Eigen::MatrixXd::Zero(2, dense.cols());
        J.middleCols<2>(3 * static_cast<Eigen::Index>(to)).setIdentity();
        J.middleCols<2>(3 * static_cast<Eigen::Index>(from)) -= Eigen::Matrix2d::Identity();
        const Eigen::Matrix2d expected = J * dense * J.transpose();
        const Eigen::Matrix2d found = covariance.of_way(from, to);
        EXPECT_LE((found - expected).norm(), 1e-6 * expected.norm()) << from << " to " << to;
        EXPECT_EQ(found, found.transpose());
      }
    }
    EXPECT_TRUE(covariance.of_way(0, 60).isApprox(covariance.of(60).topLeftCorner<2, 2>(), 1e-9));
  }
}

TEST(MarginalCovariance, IsThatOfTheErrorsOfManyRuns) {
  std::mt19937_64 generator = make_generator();
  constexpr int kNumRuns = 300;
  constexpr std::size_t kNodes[] = {20, 75, 119};
  double nees[3] = {};
  double nees_between = 0.0;
  for (int run = 0; run < kNumRuns; ++run) {
    PoseGraphSimulation simulation{.num_nodes = 120, .num_blocks = 1, .num_closures = 25};
    SimulatedPoseGraph simulated = simulate_pose_graph(simulation, generator);
    for (std::size_t k = 0; k < simulated.truth.size(); ++k) {
      simulated.graph.T_map_node[k] = simulated.truth[k];  // A good start.
    }
    polish(simulated.graph);
    const MarginalCovariance covariance(simulated.graph);
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d error =
          difference(simulated.graph.T_map_node[kNodes[k]], simulated.truth[kNodes[k]]);
      nees[k] += error.dot(covariance.of(kNodes[k]).inverse() * error) / kNumRuns;
    }
    const Eigen::Vector3d error =
        difference(simulated.graph.T_map_node[20].inverse() * simulated.graph.T_map_node[75],
                   simulated.truth[20].inverse() * simulated.truth[75]);
    nees_between += error.dot(covariance.between(20, 75).inverse() * error) / kNumRuns;
  }
  // Mean chi-squared of three degrees of freedom, within five of its standard deviations.
  const double tolerance = 5.0 * std::sqrt(6.0 / kNumRuns);
  for (const double value : nees) EXPECT_NEAR(value, 3.0, tolerance);
  EXPECT_NEAR(nees_between, 3.0, tolerance);
}

TEST(MarginalCovariance, AnOpenPoseIsAnError) {
  PoseGraph graph;
  graph.T_map_node.resize(2);
  EXPECT_THROW(MarginalCovariance{graph}, ParameterError);
}

}  // namespace setsquare::marginal_covariance_test
