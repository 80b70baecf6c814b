// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/robust_pose_graph.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <tuple>

#include "setsquare/core/error.hpp"
#include "tests/graph/simulated_pose_graph.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::robust_pose_graph_test {

using testing::make_generator;
using testing::mean_position_error_m;
using testing::PoseGraphSimulation;
using testing::simulate_pose_graph;
using testing::SimulatedPoseGraph;
using testing::WrongClosures;

constexpr auto kClosure = ConstraintKind::kLoopClosure;

/// A straight chain of nodes 1 m apart that closures can hardly move.
PoseGraph stiff_chain(std::size_t num_nodes) {
  PoseGraph graph;
  graph.T_map_node.resize(num_nodes);
  for (std::size_t node = 1; node < num_nodes; ++node) {
    Constraint step;
    step.from = node - 1;
    step.to = node;
    step.T_from_to.x_m = 1.0;
    step.information = 1e9 * Eigen::Matrix3d::Identity();
    graph.constraints.push_back(step);
  }
  return graph;
}

/// A closure to node 2 of a straight chain, off by a distance along x, with a sigma of 1 m.
Constraint closure_off_by(double off_m) {
  Constraint closure;
  closure.to = 2;
  closure.T_from_to.x_m = 2.0 + off_m;
  closure.kind = kClosure;
  return closure;
}

double weight_of_only(const Constraint& closure) {
  PoseGraph graph = stiff_chain(3);
  graph.constraints.push_back(closure);
  solve_robustly(graph);
  return graph.constraints.back().weight;
}

TEST(RobustPoseGraph, RightClosuresStay) {
  std::mt19937_64 generator = make_generator();
  SimulatedPoseGraph simulated = simulate_pose_graph({.num_closures = 400}, generator);
  solve_robustly(simulated.graph);
  const auto num_kept =
      std::ranges::count_if(simulated.graph.constraints, [](const Constraint& constraint) {
        return constraint.kind == kClosure && constraint.weight == 1.0;
      });
  EXPECT_GE(num_kept, 396);
}

/// Share of wrong closures, how many neighbours claim the same, slip (0: any two places), and
/// whether it is known which were found together.
using WrongCase = std::tuple<double, std::size_t, double, bool>;
class WrongClosuresInjected : public ::testing::TestWithParam<WrongCase> {};

TEST_P(WrongClosuresInjected, GiveTheSameMap) {
  const auto [share, group_size, slip_m, are_groups_known] = GetParam();
  std::mt19937_64 generator = make_generator();
  for (int building = 0; building < 5; ++building) {
    SimulatedPoseGraph simulated = simulate_pose_graph({}, generator);
    SimulatedPoseGraph without = simulated;
    solve_robustly(without.graph);
    inject({.share = share, .group_size = group_size, .slip_m = slip_m}, simulated, generator);
    solve_robustly(simulated.graph,
                   are_groups_known ? std::span<const std::size_t>(simulated.groups)
                                    : std::span<const std::size_t>());
    EXPECT_LE(mean_position_error_m(simulated), 1.1 * mean_position_error_m(without))
        << "building " << building;
    for (std::size_t k = without.graph.constraints.size(); k < simulated.groups.size(); ++k) {
      EXPECT_LE(simulated.graph.constraints[k].weight, 0.3) << "building " << building << ", " << k;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(RobustPoseGraph,
                         WrongClosuresInjected,
                         ::testing::Values(WrongCase{0.3, 1, 0.0, false},
                                           WrongCase{0.3, 5, 0.0, false},
                                           WrongCase{0.3, 5, 0.0, true},
                                           WrongCase{0.3, 5, 1.5, false},
                                           WrongCase{0.6, 1, 0.0, false},
                                           WrongCase{0.6, 1, 5.0, false},
                                           WrongCase{0.6, 5, 0.0, false},
                                           WrongCase{0.6, 5, 0.0, true},
                                           WrongCase{0.6, 5, 5.0, false},
                                           WrongCase{0.6, 5, 5.0, true},
                                           WrongCase{0.6, 5, 1.5, true}));

TEST(RobustPoseGraph, LooseOdometryAndFewClosures) {
  // Where full weights alone failed in nearly every building.
  std::mt19937_64 generator = make_generator();
  int num_same = 0;
  for (int building = 0; building < 10; ++building) {
    SimulatedPoseGraph simulated =
        simulate_pose_graph({.num_closures = 40, .odometry_sigma_m = 0.05}, generator);
    SimulatedPoseGraph without = simulated;
    solve_robustly(without.graph);
    inject({.share = 0.3, .group_size = 5}, simulated, generator);
    solve_robustly(simulated.graph);
    num_same += mean_position_error_m(simulated) <= 1.1 * mean_position_error_m(without) ? 1 : 0;
  }
  EXPECT_GE(num_same, 7);
}

TEST(RobustPoseGraph, OdometryWorseThanItsInformationDoesNotRefuseTheRightClosures) {
  std::mt19937_64 generator = make_generator();
  SimulatedPoseGraph simulated = simulate_pose_graph({}, generator);
  for (Constraint& constraint : simulated.graph.constraints) {
    if (constraint.kind == kClosure) continue;
    constraint.T_from_to.x_m *= 0.97;  // Odometry alone would refuse nearly all.
  }
  testing::inject({.share = 0.3, .group_size = 5}, simulated, generator);
  solve_robustly(simulated.graph);
  double weight = 0.0;
  const std::size_t first = simulated.truth.size() - 1;
  for (std::size_t k = first; k < first + 150; ++k) weight += simulated.graph.constraints[k].weight;
  EXPECT_GE(weight, 140.0);
}

TEST(RobustPoseGraph, TheOneClosureOfALongLoopStays) {
  PoseGraph graph = stiff_chain(400);
  for (Constraint& step : graph.constraints) step.information = 1e4 * Eigen::Matrix3d::Identity();
  Constraint closure;
  closure.to = 399;
  closure.T_from_to.x_m = 396.0;  // 3 m, where odometry says 0.2.
  closure.information = 1e4 * Eigen::Matrix3d::Identity();
  closure.kind = kClosure;
  graph.constraints.push_back(closure);
  solve_robustly(graph);
  EXPECT_EQ(graph.constraints.back().weight, 1.0);
  EXPECT_NEAR(graph.T_map_node[399].x_m, 396.0, 0.01);
}

TEST(RobustPoseGraph, TheThresholdOfOneAxisIsAsRare) {
  const Eigen::Matrix3d both = Eigen::Vector3d(1.0, 1.0, 1.0).asDiagonal();
  const Eigen::Matrix3d one = Eigen::Vector3d(1.0, 0.0, 1.0).asDiagonal();
  Constraint closure = closure_off_by(std::sqrt(15.9));
  EXPECT_GT(weight_of_only(closure), 0.9);
  closure = closure_off_by(std::sqrt(16.1));
  EXPECT_LT(weight_of_only(closure), 0.1);
  closure = closure_off_by(std::sqrt(12.8));
  closure.information = one;
  EXPECT_GT(weight_of_only(closure), 0.9);
  closure = closure_off_by(std::sqrt(13.0));
  closure.information = one;
  EXPECT_LT(weight_of_only(closure), 0.1);
  // Along the open axis anything goes.
  closure = closure_off_by(0.0);
  closure.T_from_to.y_m = 50.0;
  closure.information = one;
  EXPECT_EQ(weight_of_only(closure), 1.0);
  closure.information = both;
  EXPECT_EQ(weight_of_only(closure), 0.0);
}

TEST(RobustPoseGraph, AGroupStandsOrFallsByItsMean) {
  PoseGraph graph = stiff_chain(3);
  for (const double off_m : {0.0, 0.0, 6.0, 6.0, 6.0}) {
    graph.constraints.push_back(closure_off_by(off_m));
  }
  PoseGraph grouped = graph;
  solve_robustly(graph);
  EXPECT_EQ(graph.constraints[4].weight, 0.0);  // 36 alone.
  const std::size_t groups[] = {9, 9, 1, 2, 1, 1, 2};
  solve_robustly(grouped, groups);
  EXPECT_EQ(grouped.constraints[2].weight, 0.0);  // (0 + 36 + 36) / 3
  EXPECT_EQ(grouped.constraints[4].weight, 0.0);
  EXPECT_EQ(grouped.constraints[5].weight, 0.0);
  EXPECT_EQ(grouped.constraints[3].weight, grouped.constraints[6].weight);  // 36 / 2
  EXPECT_EQ(grouped.constraints[0].weight, 1.0);
}

/// Five closures that take one place for another, 4 m beside it, across a step of the track that
/// nothing holds: odometry contradicts two of them firmly, three hardly.
PoseGraph claim_across_a_loose_step() {
  PoseGraph graph = stiff_chain(40);
  graph.constraints[33].information = Eigen::Matrix3d::Identity();  // From node 33 to 34.
  graph.constraints[36].information = Eigen::Matrix3d::Identity();
  for (std::size_t i = 0; i < 5; ++i) {
    Constraint closure;
    closure.from = i;
    closure.to = 32 + i;
    closure.T_from_to.x_m = 32.0;
    closure.T_from_to.y_m = 4.0;
    closure.information = 1e4 * Eigen::Matrix3d::Identity();
    closure.kind = kClosure;
    graph.constraints.push_back(closure);
  }
  return graph;
}

double largest_closure_weight(PoseGraph graph, const RobustPoseGraphParams& params) {
  solve_robustly(graph, {}, params);
  double largest = 0.0;
  for (const Constraint& constraint : graph.constraints) {
    if (constraint.kind == kClosure) largest = std::max(largest, constraint.weight);
  }
  return largest;
}

TEST(RobustPoseGraph, AWrongClaimIsNotBelievedInPart) {
  EXPECT_EQ(largest_closure_weight(claim_across_a_loose_step(), {}), 0.0);
}

TEST(RobustPoseGraph, EachClosureAloneAWrongClaimIsBelievedInPart) {
  EXPECT_EQ(largest_closure_weight(claim_across_a_loose_step(), {.place_m = 0.0}), 1.0);
}

TEST(RobustPoseGraph, APieceJoinedByClosuresAloneIsPlaced) {
  PoseGraph graph = stiff_chain(6);
  graph.constraints.erase(graph.constraints.begin() + 2);  // Nodes 3 to 5 are not connected.
  EXPECT_THROW(solve_robustly(graph), ParameterError);
  Constraint joining = closure_off_by(0.0);
  joining.information *= 100.0;
  joining.to = 4;
  for (const double x_m : {4.0, 4.0, 14.0}) {
    joining.T_from_to.x_m = x_m;
    graph.constraints.push_back(joining);
  }
  solve_robustly(graph);
  EXPECT_NEAR(graph.T_map_node[4].x_m, 4.0, 1e-6);
  EXPECT_EQ(graph.constraints.back().weight, 0.0);
}

TEST(RobustPoseGraph, OldWeightsDoNotMatterAndTwiceIsTheSame) {
  std::mt19937_64 generator = make_generator();
  SimulatedPoseGraph simulated = simulate_pose_graph({}, generator);
  inject({.share = 0.3}, simulated, generator);
  PoseGraph again = simulated.graph;
  for (Constraint& constraint : again.constraints) {
    if (constraint.kind == kClosure) constraint.weight = 0.0;
  }
  solve_robustly(simulated.graph);
  solve_robustly(again);
  EXPECT_EQ(simulated.graph.T_map_node, again.T_map_node);
  for (std::size_t k = 0; k < again.constraints.size(); ++k) {
    EXPECT_EQ(simulated.graph.constraints[k].weight, again.constraints[k].weight);
  }
}

TEST(RobustPoseGraph, OdometryKeepsItsWeightAndHeadingsStay) {
  PoseGraph graph = stiff_chain(3);
  graph.constraints[0].weight = 0.25;
  graph.constraints.push_back(closure_off_by(0.5));
  for (Pose2& pose : graph.T_map_node) pose.theta_rad = 0.3;
  solve_robustly(graph);
  EXPECT_EQ(graph.constraints[0].weight, 0.25);
  for (const Pose2& pose : graph.T_map_node) EXPECT_EQ(pose.theta_rad, 0.3);
}

TEST(RobustPoseGraph, ParametersAreChecked) {
  PoseGraph graph = stiff_chain(3);
  const auto solve_with = [&graph](const RobustPoseGraphParams& params) {
    solve_robustly(graph, {}, params);
  };
  EXPECT_THROW(solve_with({.max_squared_error = 0.0}), ParameterError);
  EXPECT_THROW(solve_with({.mu_growth = 1.0}), ParameterError);
  EXPECT_THROW(solve_with({.max_iterations = 0}), ParameterError);
  const std::size_t groups[] = {0};
  EXPECT_THROW(solve_robustly(graph, groups), ParameterError);
  PoseGraph empty;
  EXPECT_NO_THROW(solve_robustly(empty));
}

}  // namespace setsquare::robust_pose_graph_test
