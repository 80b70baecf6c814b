// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/relation_graph.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "setsquare/core/error.hpp"
#include "tests/eval/random_trajectory.hpp"
#include "tests/support/pose_matchers.hpp"

namespace setsquare::relation_graph_test {

using ::testing::ElementsAre;
using testing::PoseNear;
using testing::PoseTolerance;
using testing::stamp_at;

ChainEnd at(std::size_t node) { return {node, {}, {}}; }

std::optional<ChainedPose> chain(const RelationGraph& graph,
                                 const ChainEnd& end_i,
                                 const ChainEnd& end_j,
                                 std::span<const JoinedPair> avoided = {}) {
  return graph.chain({&end_i, 1}, {&end_j, 1}, avoided);
}

/// 3 m ahead from 1 s to 2 s, then (stored backwards) 4 m ahead from 2 s to 3 s, then a half turn.
const std::vector<Relation> kStraight = {{stamp_at(1), stamp_at(2), {3, 0, 0}},
                                         {stamp_at(3), stamp_at(2), {-4, 0, 0}},
                                         {stamp_at(3), stamp_at(4), {0, 0, kPi / 2}}};

TEST(RelationGraph, StampsOnceInOrderAndFoundWithinRounding) {
  const RelationGraph graph(kStraight);
  ASSERT_EQ(graph.stamps().size(), 4U);
  EXPECT_EQ(graph.stamps()[2], stamp_at(3));
  EXPECT_EQ(graph.find(stamp_at(3.00001)), 2U);
  EXPECT_EQ(graph.find(stamp_at(2.99999)), 2U);
  EXPECT_EQ(graph.find(stamp_at(2.9)), std::nullopt);
  EXPECT_EQ(graph.find(stamp_at(9)), std::nullopt);
}

// By hand: the lever of the first relation's rotation is 4 m, that of the last ones 0.
TEST(RelationGraph, ChainsForwardsAndBackwardsWithTheLeverOfEachRotation) {
  const RelationGraphParams params = {.translation_sigma_m = 0.01, .rotation_sigma_rad = 0.002};
  const auto chained = chain(RelationGraph(kStraight, params), at(0), at(3));
  ASSERT_TRUE(chained);
  EXPECT_THAT(chained->T_i_j, PoseNear(Pose2{7, 0, kPi / 2}, PoseTolerance{}));
  EXPECT_NEAR(chained->variance.translation_m2, 3 * 1e-4 + 16.0 * 4e-6, 1e-15);
  EXPECT_NEAR(chained->variance.rotation_rad2, 3 * 4e-6, 1e-15);
  EXPECT_THAT(chained->pairs, ElementsAre(JoinedPair{0, 1}, JoinedPair{1, 2}, JoinedPair{2, 3}));
  const auto back = chain(RelationGraph(kStraight, params), at(3), at(0));
  ASSERT_TRUE(back);
  EXPECT_THAT(back->T_i_j, PoseNear(chained->T_i_j.inverse(), PoseTolerance{}));
}

TEST(RelationGraph, HopsAtEitherEndAddTheirWayAndTheirNoise) {
  const RelationGraphParams params = {.translation_sigma_m = 0.01, .rotation_sigma_rad = 0.002};
  const ChainEnd i = {0, {0.5, 0, 0}, {1e-6, 1e-6}};
  const ChainEnd j = {1, {0, 1, 0}, {4e-6, 9e-6}};
  const auto chained = chain(RelationGraph(kStraight, params), i, j);
  ASSERT_TRUE(chained);
  EXPECT_THAT(chained->T_i_j, PoseNear(Pose2{3.5, -1, 0}, PoseTolerance{}));
  // j lies 1 m aside of its node (the relation's lever) and hypot(3, 1) m from i's.
  EXPECT_NEAR(
      chained->variance.translation_m2, 4e-6 + (1e-4 + 4e-6 * 1.0) + (1e-6 + 1e-6 * 10.0), 1e-15);
  EXPECT_NEAR(chained->variance.rotation_rad2, 9e-6 + 4e-6 + 1e-6, 1e-15);
}

TEST(RelationGraph, WhatIsTooUncertainOrNotJoinedIsNoChain) {
  const RelationGraphParams strict = {.translation_sigma_m = 0.06, .rotation_sigma_rad = 1e-4};
  EXPECT_TRUE(chain(RelationGraph(kStraight, strict), at(0), at(2)));
  EXPECT_FALSE(chain(RelationGraph(kStraight, strict), at(0), at(3))) << "3 * 0.06^2 > 0.1^2";
  auto apart = kStraight;
  apart.push_back({stamp_at(7), stamp_at(8), {0, 0, 0}});
  EXPECT_FALSE(chain(RelationGraph(apart), at(0), at(4)));
  const RelationGraph graph(kStraight);
  EXPECT_FALSE(graph.chain({}, {}));
  const std::vector<JoinedPair> avoided = {{1, 2}};
  EXPECT_FALSE(chain(graph, at(0), at(3), avoided));
  EXPECT_TRUE(chain(graph, at(0), at(1), avoided));
}

/// The plain twin: every way from `node` to `goal` that meets no node twice.
double least_cost(const std::vector<Relation>& relations,
                  const Trajectory& truth,
                  const RelationGraphParams& params,
                  std::vector<bool>& is_visited,
                  std::size_t node,
                  std::size_t goal,
                  double cost) {
  if (node == goal) return cost;
  is_visited[node] = true;
  double least = 1e9;
  for (const Relation& relation : relations) {
    auto a = static_cast<std::size_t>(std::lround(relation.reference_stamp.seconds()));
    auto b = static_cast<std::size_t>(std::lround(relation.current_stamp.seconds()));
    if (b == node) std::swap(a, b);
    if (a != node || is_visited[b]) continue;
    const double lever_m = (truth[b].pose.translation() - truth[goal].pose.translation()).norm();
    const double position_m =
        std::hypot(params.translation_sigma_m, params.rotation_sigma_rad * lever_m) /
        params.max_translation_sigma_m;
    const double turn = params.rotation_sigma_rad / params.max_rotation_sigma_rad;
    const double longer = cost + position_m * position_m + turn * turn;
    least = std::min(least, least_cost(relations, truth, params, is_visited, b, goal, longer));
  }
  is_visited[node] = false;
  return least;
}

TEST(RelationGraph, NoOtherWayIsCheaper) {
  auto generator = testing::make_generator();
  int num_chained = 0;
  for (int run = 0; run < 300; ++run) {
    const Trajectory truth = testing::random_trajectory(generator, 8);
    std::vector<Relation> relations;
    const auto join = [&](std::size_t a, std::size_t b) {
      relations.push_back(
          {truth[a].stamp, truth[b].stamp, truth[a].pose.inverse() * truth[b].pose});
    };
    for (std::size_t a = 0; a + 1 < 8; ++a) join(a, a + 1);
    for (int k = 0; k < 4; ++k) join(generator() % 8, generator() % 8);
    const RelationGraphParams params = {.translation_sigma_m = 0.03, .rotation_sigma_rad = 0.0025};
    const auto chained = chain(RelationGraph(relations, params), at(0), at(7));
    std::vector<bool> is_visited(8, false);
    const double expected = least_cost(relations, truth, params, is_visited, 0, 7, 0.0);
    ASSERT_EQ(chained.has_value(), expected <= 1.0);
    if (!chained) continue;
    ++num_chained;
    EXPECT_NEAR(chained->cost, expected, 1e-9);
    EXPECT_THAT(chained->T_i_j, PoseNear(truth[0].pose.inverse() * truth[7].pose, PoseTolerance{}));
  }
  EXPECT_GT(num_chained, 30);
  EXPECT_LT(num_chained, 270);
}

TEST(RelationGraph, ParametersOutsideTheirDomainAreNamed) {
  RelationGraphParams params;
  params.rotation_sigma_rad = 0.0;
  try {
    const RelationGraph graph(kStraight, params);
    FAIL();
  } catch (const ParameterError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("rotation_sigma_rad"));
  }
}

}  // namespace setsquare::relation_graph_test
