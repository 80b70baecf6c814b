// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/tables/pose_graph_g2o.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "setsquare/core/error.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::pose_graph_g2o_test {

using ::testing::HasSubstr;
using ::testing::SizeIs;

PoseGraphG2o read(const std::string& text) {
  return read_pose_graph_g2o(make_memory_source(text), "x.g2o");
}

std::string error_of(const std::string& text) {
  try {
    static_cast<void>(read(text));
  } catch (const FormatError& error) {
    return error.what();
  }
  return {};
}

Pose2 random_pose(std::mt19937_64& generator) {
  return {testing::uniform(generator, -1e3, 1e3),
          testing::uniform(generator, -1e3, 1e3),
          testing::uniform(generator, -kPi, kPi)};
}

Constraint random_constraint(std::size_t from, std::size_t to, std::mt19937_64& generator) {
  Constraint constraint;
  constraint.from = from;
  constraint.to = to;
  constraint.T_from_to = random_pose(generator);
  Eigen::Matrix3d root;
  for (double& value : root.reshaped()) value = testing::uniform(generator, -30.0, 30.0);
  constraint.information = root * root.transpose();
  return constraint;
}

PoseGraph random_graph(std::mt19937_64& generator) {
  PoseGraph graph;
  for (std::size_t k = 0; k < 300; ++k) {
    graph.T_map_node.push_back(random_pose(generator));
    if (k > 0) graph.constraints.push_back(random_constraint(k - 1, k, generator));
    graph.headings.push_back(
        {k, testing::uniform(generator, -4.0, 4.0), 1e3 * static_cast<double>(k)});
  }
  for (std::size_t k = 0; k < 100; ++k) {
    graph.constraints.push_back(random_constraint(2 * k, 290 - k / 2, generator));
    graph.constraints.back().kind = ConstraintKind::kLoopClosure;
  }
  return graph;
}

const std::string kSmall =
    "VERTEX_SE2 0 0 0 0\n"
    "VERTEX_SE2 1 0.1 -2.5 1.5\n"
    "VERTEX_SE2 2 1e-07 3 -1.5\n"
    "FIX 0\n"
    "EDGE_SE2 0 1 0.1 -2.5 0 100 1 2 200 3 300\n"
    "EDGE_SE2 0 2 1 2 0 50 0 0 50 0 5\n"
    "EDGE_PRIOR_SE2 2 1e-07 3 -1.5 0 0 0 0 0 1234.5\n";

TEST(PoseGraphG2o, WritesWhatItReads) {
  const PoseGraphG2o small = read(kSmall);
  EXPECT_EQ(small.num_passed_over, 0U);
  const PoseGraph& graph = small.graph;
  ASSERT_THAT(graph.T_map_node, SizeIs(3));
  EXPECT_EQ(graph.T_map_node[1], (Pose2{0.1, -2.5, 1.5}));
  ASSERT_THAT(graph.constraints, SizeIs(2));
  EXPECT_EQ(graph.constraints[0].kind, ConstraintKind::kOdometry);
  EXPECT_EQ(graph.constraints[1].kind, ConstraintKind::kLoopClosure);
  Eigen::Matrix3d information;
  information << 100.0, 1.0, 2.0, 1.0, 200.0, 3.0, 2.0, 3.0, 300.0;
  EXPECT_EQ(graph.constraints[0].information, information);
  ASSERT_THAT(graph.headings, SizeIs(1));
  EXPECT_EQ(graph.headings[0].node, 2U);
  EXPECT_EQ(graph.headings[0].heading_rad, -1.5);
  EXPECT_EQ(graph.headings[0].information_per_rad2, 1234.5);
  EXPECT_EQ(g2o_from_pose_graph(graph), kSmall);
}

TEST(PoseGraphG2o, RoundTrip) {
  auto generator = testing::make_generator();
  const PoseGraph graph = random_graph(generator);
  const PoseGraph again = read(g2o_from_pose_graph(graph)).graph;
  EXPECT_EQ(again.T_map_node, graph.T_map_node);  // To the last digit.
  ASSERT_EQ(again.constraints.size(), graph.constraints.size());
  for (std::size_t k = 0; k < graph.constraints.size(); ++k) {
    EXPECT_EQ(again.constraints[k].from, graph.constraints[k].from);
    EXPECT_EQ(again.constraints[k].to, graph.constraints[k].to);
    EXPECT_EQ(again.constraints[k].kind, graph.constraints[k].kind);
    EXPECT_EQ(again.constraints[k].T_from_to, graph.constraints[k].T_from_to);
    // Turned there and back.
    EXPECT_TRUE(again.constraints[k].information.isApprox(graph.constraints[k].information, 1e-14));
  }
  ASSERT_EQ(again.headings.size(), graph.headings.size());
  for (std::size_t k = 0; k < graph.headings.size(); ++k) {
    EXPECT_EQ(again.headings[k].heading_rad, graph.headings[k].heading_rad);
    EXPECT_EQ(again.headings[k].information_per_rad2, graph.headings[k].information_per_rad2);
  }
}

TEST(PoseGraphG2o, G2osResidualHasTheSameSquaredError) {
  // EDGE_SE2: the vector of z^-1 (x_i^-1 x_j).
  auto generator = testing::make_generator();
  PoseGraph graph;
  graph.T_map_node = {random_pose(generator), random_pose(generator)};
  Constraint constraint = random_constraint(0, 1, generator);
  constraint.weight = 0.25;
  graph.constraints = {constraint};
  std::string text = g2o_from_pose_graph(graph);
  text.erase(0, text.find("EDGE_SE2 0 1 "));
  double numbers[9];
  ASSERT_EQ(std::sscanf(text.c_str(),
                        "EDGE_SE2 0 1 %lf %lf %lf %lf %lf %lf %lf %lf %lf",
                        &numbers[0],
                        &numbers[1],
                        &numbers[2],
                        &numbers[3],
                        &numbers[4],
                        &numbers[5],
                        &numbers[6],
                        &numbers[7],
                        &numbers[8]),
            9);
  const Pose2 z{numbers[0], numbers[1], numbers[2]};
  const Pose2 error = z.inverse() * (graph.T_map_node[0].inverse() * graph.T_map_node[1]);
  const Eigen::Vector3d e(error.x_m, error.y_m, error.theta_rad);
  Eigen::Matrix3d information;
  information << numbers[3], numbers[4], numbers[5], numbers[4], numbers[6], numbers[7], numbers[5],
      numbers[7], numbers[8];
  const double expected = 0.25 * squared_error(graph, constraint);
  EXPECT_NEAR(e.dot(information * e), expected, 1e-9 * expected);
}

TEST(PoseGraphG2o, OdometryIsWrittenFirst) {
  PoseGraph graph = read(kSmall).graph;
  std::swap(graph.constraints[0], graph.constraints[1]);
  EXPECT_EQ(g2o_from_pose_graph(graph), kSmall);
}

TEST(PoseGraphG2o, IdsMayHaveGapsAndLinesStandInAnyOrder) {
  const PoseGraph graph = read(
                              "EDGE_SE2 70 4 1 2 0 1 0 0 1 0 1\n"
                              "VERTEX_SE2 70 7 0 0\n"
                              "EDGE_PRIOR_SE2 4000000000 0 0 0.5 0 0 0 0 0 2\r\n"
                              "VERTEX_SE2 4000000000 8 0 0\n"
                              "VERTEX_SE2 4 6 0 0\n"
                              "EDGE_SE2 4 4000000000 1 2 0 1 0 0 1 0 1")
                              .graph;
  ASSERT_THAT(graph.T_map_node, SizeIs(3));
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(graph.T_map_node[k].x_m, 6.0 + static_cast<double>(k));
  ASSERT_THAT(graph.constraints, SizeIs(2));
  EXPECT_EQ(graph.constraints[0].from, 1U);
  EXPECT_EQ(graph.constraints[0].to, 0U);
  EXPECT_EQ(graph.constraints[0].kind, ConstraintKind::kOdometry);
  EXPECT_EQ(graph.constraints[1].to, 2U);
  EXPECT_EQ(graph.constraints[1].kind, ConstraintKind::kLoopClosure);
  EXPECT_EQ(graph.headings.at(0).node, 2U);
}

TEST(PoseGraphG2o, OtherLinesArePassedOverAndCounted) {
  const PoseGraphG2o content = read("# comment\n\nPARAMS_SE2OFFSET 0 0 0 0\n" + kSmall +
                                    "VERTEX_XY 9 1 2\nEDGE_SE2_XY 0 9 1 2 1 0 1\n");
  EXPECT_EQ(content.num_passed_over, 3U);
  EXPECT_EQ(g2o_from_pose_graph(content.graph), kSmall);
}

TEST(PoseGraphG2o, ADamagedLineIsNamed) {
  EXPECT_THAT(error_of("VERTEX_SE2 0 0 0\n"), HasSubstr("x.g2o, line 1: expected \"VERTEX_SE2"));
  EXPECT_THAT(error_of("VERTEX_SE2 -1 0 0 0\n"), HasSubstr("line 1"));
  EXPECT_THAT(error_of("VERTEX_SE2 1.5 0 0 0\n"), HasSubstr("line 1"));
  EXPECT_THAT(error_of("VERTEX_SE2 1 0 nan 0\n"), HasSubstr("line 1"));
  EXPECT_THAT(error_of("VERTEX_SE2 1 0 0 0 0\n"), HasSubstr("line 1"));
  EXPECT_THAT(error_of(kSmall + "VERTEX_SE2 1 0 0 0\n"), HasSubstr("line 8: vertex 1 again"));
  const auto edge_error = [](const std::string& edge) { return error_of(kSmall + edge + '\n'); };
  EXPECT_THAT(edge_error("EDGE_SE2 0 1 0 0 0 1 0 0 1 0"), HasSubstr("line 8: expected \"EDGE_SE2"));
  EXPECT_THAT(edge_error("EDGE_SE2 0 1 0 0 0 1 0 0 1 0 1 1"), HasSubstr("line 8"));
  EXPECT_THAT(edge_error("EDGE_SE2 0 1 0 0 0 inf 0 0 1 0 1"), HasSubstr("line 8"));
  EXPECT_THAT(edge_error("EDGE_SE2 0 1 0 0 0 -1 0 0 1 0 1"), HasSubstr("line 8"));
  EXPECT_THAT(edge_error("EDGE_SE2 0 1 0 0 0 1 2 0 1 0 1"), HasSubstr("line 8"));
  EXPECT_THAT(edge_error("EDGE_SE2 0 1 0 0 0 1e300 0 0 1 0 1"), HasSubstr("line 8"));
  EXPECT_THAT(edge_error("EDGE_SE2 0 3 0 0 0 1 0 0 1 0 1"), HasSubstr("no vertex 3"));
  EXPECT_THAT(edge_error("EDGE_SE2 2 2 0 0 0 1 0 0 1 0 1"), HasSubstr("two nodes"));
  EXPECT_THAT(edge_error("EDGE_PRIOR_SE2 0 0 0 0 1 0 0 1 0"), HasSubstr("EDGE_PRIOR_SE2"));
  EXPECT_THAT(edge_error("EDGE_PRIOR_SE2 3 0 0 0 0 0 0 0 0 1"), HasSubstr("no vertex 3"));
  EXPECT_THAT(edge_error("FIX"), HasSubstr("line 8"));
  EXPECT_THAT(error_of(""), HasSubstr("no line"));
  EXPECT_THAT(error_of("FIX 0\n"), HasSubstr("no line"));
}

TEST(PoseGraphG2o, CutAtEveryOffsetIsAnErrorOrShorter) {
  for (std::size_t length = 0; length < kSmall.size(); ++length) {
    try {
      const PoseGraph graph = read(kSmall.substr(0, length)).graph;
      EXPECT_NO_THROW(validate(graph));
      EXPECT_LE(graph.constraints.size(), 2U);
    } catch (const FormatError&) {
      continue;
    }
  }
}

TEST(PoseGraphG2o, AHundredThousandNodesInReverseTakeNoTime) {
  std::string text;
  for (int id = 100000; id-- > 1;) {
    const std::string name = std::to_string(id);
    text += "VERTEX_SE2 " + name + " 1 2 3\n";
    text += "EDGE_SE2 " + name + " " + std::to_string(id - 1) + " 1 2 3 1 0 0 1 0 1\n";
  }
  text += "VERTEX_SE2 0 0 0 0\n";
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THAT(read(text).graph.constraints, SizeIs(99999));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(PoseGraphG2o, AMissingFileIsNamed) {
  EXPECT_THROW(static_cast<void>(read_pose_graph_g2o("/no/such.g2o")), FileError);
}

}  // namespace setsquare::pose_graph_g2o_test
