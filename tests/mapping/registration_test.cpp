// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/registration.hpp"

#include <gtest/gtest.h>

#include "setsquare/core/error.hpp"
#include "tests/mapping/tracked_world.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::registration_test {

using testing::between;
using testing::PoseNear;
using testing::PoseTolerance;

/// Two visits, one like the other.
std::vector<Pose2> twice(const std::vector<Pose2>& visit) {
  std::vector<Pose2> both = visit;
  both.insert(both.end(), visit.begin(), visit.end());
  return both;
}

/// Keyframes of a drive, off from where they truly are; the first, which fixes the frame, is not.
class RegistrationInRoom : public ::testing::Test {
 protected:
  RegistrationInRoom()
      : truth_(testing::spaced(testing::drive(testing::way_around_the_room()))),
        track_(testing::track_in_world(testing::l_shaped_room(), truth_, 0.0)) {
    std::mt19937_64 generator = testing::make_generator();
    std::normal_distribution<double> normal(0.0, 1.0);
    graph_.T_map_node = truth_;
    for (std::size_t k = 0; k < truth_.size(); ++k) {
      if (k > 0) {
        graph_.T_map_node[k].x_m += 0.03 * normal(generator);
        graph_.T_map_node[k].y_m += 0.03 * normal(generator);
        graph_.T_map_node[k].theta_rad += rad_from_deg(0.3) * normal(generator);
      }
      graph_.headings.push_back({k, truth_[k].theta_rad, 1e5});
    }
  }

  /// The largest distance from the truth, and the mean.
  std::pair<double, double> errors_m(const PoseGraph& graph) const {
    double largest_m = 0.0;
    double sum_m = 0.0;
    for (std::size_t k = 0; k < truth_.size(); ++k) {
      const double off_m = (graph.T_map_node[k].translation() - truth_[k].translation()).norm();
      largest_m = std::max(largest_m, off_m);
      sum_m += off_m;
    }
    return {largest_m, sum_m / static_cast<double>(truth_.size())};
  }

  std::vector<Pose2> truth_;
  KeyframeTrack track_;
  PoseGraph graph_;
};

TEST_F(RegistrationInRoom, BringsTheKeyframesBack) {
  const auto [before_m, mean_before_m] = errors_m(graph_);
  ASSERT_GT(before_m, 0.05);
  register_keyframes(track_, {}, graph_, {}, 1);
  const auto [largest_m, mean_m] = errors_m(graph_);
  EXPECT_LT(mean_m, 0.004);
  EXPECT_LT(largest_m, 0.015);
  for (std::size_t k = 0; k < truth_.size(); ++k) {
    EXPECT_LT(std::abs(wrap_to_pi(graph_.T_map_node[k].theta_rad - truth_[k].theta_rad)),
              rad_from_deg(0.1));
  }
  EXPECT_EQ(graph_.T_map_node[0].translation(), truth_[0].translation());
}

TEST_F(RegistrationInRoom, AnyNumberOfThreadsGivesTheSameBits) {
  PoseGraph other = graph_;
  register_keyframes(track_, {}, graph_, {}, 1);
  register_keyframes(track_, {}, other, {}, 3);
  EXPECT_EQ(graph_.T_map_node, other.T_map_node);
}

TEST_F(RegistrationInRoom, KeepsItsConstraintsAndHeadings) {
  Constraint step;
  step.to = 1;
  step.T_from_to = between(truth_[0], truth_[1]);
  graph_.constraints.push_back(step);
  register_keyframes(track_, {}, graph_, {}, 1);
  EXPECT_EQ(graph_.constraints.size(), 1U);
  EXPECT_EQ(graph_.headings.size(), truth_.size());
}

TEST_F(RegistrationInRoom, NoRoundsNoChange) {
  const PoseGraph before = graph_;
  register_keyframes(track_, {}, graph_, {.num_rounds = 0}, 1);
  EXPECT_EQ(graph_.T_map_node, before.T_map_node);
}

TEST_F(RegistrationInRoom, RevisitedPlacesTieTwoVisitsToEachOther) {
  // Two visits of the room; the second as a whole 3 cm off, and no track between them.
  const std::size_t n = truth_.size();
  const std::vector<Pose2> truth = twice(truth_);
  KeyframeTrack track = testing::track_in_world(testing::l_shaped_room(), truth, 0.0);
  for (std::size_t k = n; k < 2 * n; ++k) track.stretches[k] = 1;
  PoseGraph graph;
  graph.T_map_node = truth;
  for (std::size_t k = n; k < 2 * n; ++k) graph.T_map_node[k].x_m += 0.03;
  for (std::size_t k = 0; k < 2 * n; ++k) graph.headings.push_back({k, truth[k].theta_rad, 1e5});
  std::vector<Constraint> closures;
  for (std::size_t k = 5; k + 5 < n; k += 10) {
    Constraint closure;  // that only names the keyframes to compare
    closure.from = k;
    closure.to = n + k;
    closure.information.setZero();
    closures.push_back(closure);
  }
  register_keyframes(track, closures, graph, {}, 1);
  for (std::size_t k = n; k < 2 * n; ++k) {
    EXPECT_THAT(between(graph.T_map_node[k - n], graph.T_map_node[k]),
                PoseNear(Pose2{}, PoseTolerance{.translation_m = 0.005, .rotation_rad = 0.002}));
  }
}

TEST_F(RegistrationInRoom, AClosureThatNoComparisonReplacesStands) {
  // Two visits again, the second 20 m off: too far for any comparison.
  const std::size_t n = truth_.size();
  const std::vector<Pose2> truth = twice(truth_);
  KeyframeTrack track = testing::track_in_world(testing::l_shaped_room(), truth, 0.0);
  for (std::size_t k = n; k < 2 * n; ++k) track.stretches[k] = 1;
  PoseGraph graph;
  graph.T_map_node = truth;
  for (std::size_t k = n; k < 2 * n; ++k) {
    graph.T_map_node[k].x_m += 20.0;
    graph.headings.push_back({k, truth[k].theta_rad, 1e5});
  }
  Constraint closure;
  closure.from = n / 2;
  closure.to = n + n / 2;
  closure.kind = ConstraintKind::kLoopClosure;
  closure.information *= 1e4;
  register_keyframes(track, {&closure, 1}, graph, {}, 1);
  EXPECT_THAT(between(graph.T_map_node[closure.from], graph.T_map_node[closure.to]),
              PoseNear(Pose2{}, PoseTolerance{.translation_m = 0.005, .rotation_rad = 0.002}));
}

TEST_F(RegistrationInRoom, AnotherStretchNextToARevisitedPlaceIsNotCompared) {
  // The second visit ends with its keyframe n + 5; what follows is of a stretch that nothing joins.
  const std::size_t n = truth_.size();
  const std::vector<Pose2> truth = twice(truth_);
  KeyframeTrack track = testing::track_in_world(testing::l_shaped_room(), truth, 0.0);
  for (std::size_t k = n; k < 2 * n; ++k) track.stretches[k] = k <= n + 5 ? 1 : 2;
  PoseGraph graph;
  graph.T_map_node = truth;
  for (std::size_t k = n + 6; k < 2 * n; ++k) graph.T_map_node[k].x_m += 0.03;
  for (std::size_t k = 0; k < 2 * n; ++k) graph.headings.push_back({k, truth[k].theta_rad, 1e5});
  Constraint closure;
  closure.from = 5;
  closure.to = n + 5;
  closure.information.setZero();
  Constraint anchor;  // holds the stretch that nothing joins where it is
  anchor.from = n + 5;
  anchor.to = n + 6;
  anchor.T_from_to = between(graph.T_map_node[n + 5], graph.T_map_node[n + 6]);
  graph.constraints.push_back(anchor);
  register_keyframes(track, {&closure, 1}, graph, {}, 1);
  EXPECT_NEAR(
      (graph.T_map_node[n + 6].translation() - truth[n + 6].translation()).norm(), 0.03, 0.005);
}

TEST(Registration, RefusesParametersThatAreNone) {
  EXPECT_THROW(RegistrationParams{.num_rounds = -1}.validate(), ParameterError);
  EXPECT_THROW(RegistrationParams{.point_sigma_m = 0.0}.validate(), ParameterError);
}

/// How far registration moves the keyframes in the middle of a bare corridor against each other,
/// along it (m, mean). Each was laid out 3 cm from where it truly is, and nothing shows that.
double moved_along_corridor_m(double min_effective_points) {
  const std::vector<testing::Wall> walls = {{-50.0, -1.0, 50.0, -1.0}, {50.0, 1.0, -50.0, 1.0}};
  std::vector<Pose2> truth;
  for (int k = 0; k < 20; ++k) truth.push_back({0.4 * k, 0.0, 0.0});
  const KeyframeTrack track = testing::track_in_world(walls, truth, 0.01);
  std::mt19937_64 generator = testing::make_generator();
  std::normal_distribution<double> normal(0.0, 1.0);
  PoseGraph graph;
  graph.T_map_node = truth;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    if (k > 0) graph.T_map_node[k].x_m += 0.03 * normal(generator);
    graph.headings.push_back({k, 0.0, 1e5});
  }
  const std::vector<Pose2> before = graph.T_map_node;
  RegistrationParams params;
  params.min_effective_points = min_effective_points;
  register_keyframes(track, {}, graph, params, 1);
  double moved_m = 0.0;
  for (std::size_t k = 1; k < truth.size(); ++k) {
    const double step_m = graph.T_map_node[k].x_m - graph.T_map_node[k - 1].x_m;
    moved_m += std::abs(step_m - (before[k].x_m - before[k - 1].x_m));
  }
  return moved_m / static_cast<double>(truth.size() - 1);
}

TEST(Registration, KeyframesInABareCorridorStayWhereTheGraphHasThemAlongIt) {
  EXPECT_LT(moved_along_corridor_m(RegistrationParams{}.min_effective_points), 0.002);
  EXPECT_GT(moved_along_corridor_m(0.0), 0.01) << "without the rule";
}

}  // namespace setsquare::registration_test
