// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/pose_graph.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <string>

#include "setsquare/core/error.hpp"
#include "setsquare/graph/pose_equations.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::pose_graph_test {

using ::testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

PoseGraph two_nodes() {
  PoseGraph graph;
  graph.T_map_node = {{1.0, 2.0, 0.5 * kPi}, {1.0, 5.0, -kPi}};
  Constraint constraint;
  constraint.to = 1;
  constraint.T_from_to = {2.5, 0.25, 0.5 * kPi};
  graph.constraints = {constraint};
  graph.headings = {{.node = 1, .heading_rad = 3.0, .information_per_rad2 = 4.0}};
  return graph;
}

std::string fault(const PoseGraph& graph) {
  try {
    validate(graph);
  } catch (const ParameterError& error) {
    return error.what();
  }
  return {};
}

TEST(PoseGraph, ResidualIsInTheFrameOfTheFirstNode) {
  const PoseGraph graph = two_nodes();
  // Node 1 is 3 m ahead of node 0 and turned by a quarter to the left of it.
  EXPECT_TRUE(
      residual(graph, graph.constraints[0]).isApprox(Eigen::Vector3d(0.5, -0.25, 0.0), 1e-12));
}

TEST(PoseGraph, ResidualsAngleIsWrapped) {
  PoseGraph graph = two_nodes();
  graph.constraints[0].T_from_to.theta_rad = 0.5 * kPi + 0.1 - kTwoPi;
  EXPECT_NEAR(residual(graph, graph.constraints[0]).z(), -0.1, 1e-12);
}

TEST(PoseGraph, SquaredErrorHasNoWeightAndCostHas) {
  PoseGraph graph = two_nodes();
  graph.constraints[0].information = Eigen::Vector3d(4.0, 16.0, 1.0).asDiagonal();
  graph.constraints[0].weight = 0.5;
  EXPECT_NEAR(squared_error(graph, graph.constraints[0]), 2.0, 1e-12);
  const double heading_residual = kPi - 3.0;
  EXPECT_NEAR(cost(graph), 0.5 * (1.0 + 4.0 * heading_residual * heading_residual), 1e-12);
}

TEST(PoseGraph, JacobiansAreThoseOfDifferences) {
  std::mt19937_64 generator = testing::make_generator();
  for (int repetition = 0; repetition < 100; ++repetition) {
    PoseGraph graph = two_nodes();
    for (Pose2& pose : graph.T_map_node) {
      pose = {testing::uniform(generator, -9.0, 9.0),
              testing::uniform(generator, -9.0, 9.0),
              testing::uniform(generator, -kPi, kPi)};
    }
    const auto jacobians = residual_jacobians(graph, graph.constraints[0]);
    constexpr double kStep = 1e-5;
    for (std::size_t node = 0; node < 2; ++node) {
      for (int k = 0; k < 3; ++k) {
        const auto moved = [&](double step) {
          PoseGraph other = graph;
          Pose2& pose = other.T_map_node[node];
          (k == 0 ? pose.x_m : k == 1 ? pose.y_m : pose.theta_rad) += step;
          return residual(other, other.constraints[0]);
        };
        Eigen::Vector3d difference = moved(kStep) - moved(-kStep);
        difference.z() = wrap_to_pi(difference.z());
        const Eigen::Vector3d column = (node == 0 ? jacobians.from : jacobians.to).col(k);
        EXPECT_LT((difference / (2.0 * kStep) - column).norm(), 1e-8)
            << "node " << node << ", " << k;
      }
    }
  }
}

TEST(PoseGraph, WhatIsWrongIsNamed) {
  EXPECT_EQ(fault(two_nodes()), "");
  const auto fault_after = [](auto change) {
    PoseGraph graph = two_nodes();
    change(graph);
    return fault(graph);
  };
  EXPECT_THAT(fault_after([](PoseGraph& g) { g.T_map_node[1].y_m = kNan; }),
              HasSubstr("T_map_node[1]"));
  EXPECT_THAT(fault_after([](PoseGraph& g) { g.constraints[0].to = 2; }),
              HasSubstr("constraints[0]"));
  EXPECT_THAT(fault_after([](PoseGraph& g) { g.constraints[0].to = 0; }), HasSubstr("two nodes"));
  EXPECT_THAT(fault_after([](PoseGraph& g) { g.constraints[0].T_from_to.x_m = kNan; }),
              HasSubstr("pose"));
  EXPECT_THAT(fault_after([](PoseGraph& g) { g.constraints[0].information(0, 1) = kNan; }),
              HasSubstr("information"));
  EXPECT_THAT(fault_after([](PoseGraph& g) { g.constraints[0].information(2, 2) = -1.0; }),
              HasSubstr("negative"));
  EXPECT_THAT(fault_after([](PoseGraph& g) { g.constraints[0].weight = 1.5; }),
              HasSubstr("weight"));
  EXPECT_THAT(fault_after([](PoseGraph& g) { g.constraints[0].weight = kNan; }),
              HasSubstr("weight"));
  EXPECT_THAT(fault_after([](PoseGraph& g) { g.headings[0].node = 2; }), HasSubstr("headings[0]"));
  EXPECT_THAT(fault_after([](PoseGraph& g) { g.headings[0].heading_rad = kNan; }),
              HasSubstr("headings[0]"));
  EXPECT_THAT(fault_after([](PoseGraph& g) { g.headings[0].information_per_rad2 = -1.0; }),
              HasSubstr("negative"));
}

}  // namespace setsquare::pose_graph_test
