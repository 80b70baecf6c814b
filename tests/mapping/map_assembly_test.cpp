// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/map_assembly.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "setsquare/matching/information.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::map_assembly_test {

using testing::PoseNear;
using testing::PoseTolerance;
using testing::uniform;

Pose2 random_pose(std::mt19937_64& generator) {
  return {
      uniform(generator, -3.0, 3.0), uniform(generator, -3.0, 3.0), uniform(generator, -kPi, kPi)};
}

/// Sensors mounted at an angle, a different one per scan, at random poses with constraints between
/// them.
struct MountedTrack {
  explicit MountedTrack(std::size_t num) {
    for (std::size_t k = 0; k < num; ++k) {
      Keyframe keyframe;
      keyframe.scan_index = 10 * k;
      Scan scan;
      scan.stamp.ns = static_cast<std::int64_t>(k) * 1000;
      scan.T_base_sensor = random_pose(generator);
      keyframe.scan = std::make_shared<const Scan>(scan);
      track.keyframes.push_back(std::make_shared<Keyframe>(keyframe));
      track.motions.emplace_back();
      track.stretches.push_back(0);
      track.pieces.push_back(0);
      graph.T_map_node.push_back(random_pose(generator));
      graph.headings.push_back({k, graph.T_map_node[k].theta_rad, 100.0});
      if (k == 0) continue;
      Constraint constraint;
      constraint.from = k - 1;
      constraint.to = k;
      constraint.T_from_to = graph.T_map_node[k - 1].inverse() * graph.T_map_node[k];
      Eigen::Matrix3d root;
      for (int i = 0; i < 9; ++i) root(i / 3, i % 3) = uniform(generator, -1.0, 1.0);
      constraint.information = root * root.transpose() + 0.1 * Eigen::Matrix3d::Identity();
      graph.constraints.push_back(constraint);
    }
  }
  std::mt19937_64 generator = testing::make_generator();
  KeyframeTrack track;
  PoseGraph graph;  ///< Of the sensors.
};

TEST(GraphOfBase, ResidualsVanishWhereThoseOfTheSensorsDo) {
  const MountedTrack mounted(12);
  const PoseGraph of_base = graph_of_base(mounted.track, mounted.graph);
  for (const Constraint& constraint : of_base.constraints) {
    EXPECT_LT(residual(of_base, constraint).norm(), 1e-9);
  }
  for (std::size_t k = 0; k < 12; ++k) {
    EXPECT_THAT(of_base.T_map_node[k] * mounted.track.keyframes[k]->scan->T_base_sensor,
                PoseNear(mounted.graph.T_map_node[k], PoseTolerance{}));
    EXPECT_NEAR(
        wrap_to_pi(of_base.headings[k].heading_rad - of_base.T_map_node[k].theta_rad), 0.0, 1e-9);
  }
}

TEST(GraphOfBase, SquaredErrorsAreThoseOfTheSensors) {
  MountedTrack mounted(12);
  for (Pose2& pose : mounted.graph.T_map_node) {
    pose = pose * Pose2{uniform(mounted.generator, -1e-4, 1e-4),
                        uniform(mounted.generator, -1e-4, 1e-4),
                        uniform(mounted.generator, -1e-4, 1e-4)};
  }
  const PoseGraph of_base = graph_of_base(mounted.track, mounted.graph);
  for (std::size_t k = 0; k < of_base.constraints.size(); ++k) {
    const double of_sensor = squared_error(mounted.graph, mounted.graph.constraints[k]);
    EXPECT_NEAR(squared_error(of_base, of_base.constraints[k]), of_sensor, 1e-3 * of_sensor);
  }
}

ComparedPlaces places(std::size_t from, std::size_t to, const ClosureVerdict& verdict) {
  ComparedPlaces compared;
  compared.from = from;
  compared.to = to;
  compared.T_from_to = {1.0 - 0.1 * static_cast<double>(from), 0.2, 0.1};
  compared.information = Eigen::Vector3d(100.0, 80.0, 500.0).asDiagonal();
  compared.verdict = verdict;
  return compared;
}

TEST(MappedClosures, HaveThePosesOfTheBaseAndTheFinalWeights) {
  MountedTrack mounted(8);
  std::vector<ComparedPlaces> compared = {
      places(0, 6, {ClosureReason::kStandsAlone, ClosureAxes::kXY}),
      places(1, 6, {ClosureReason::kAmbiguous, ClosureAxes::kXY}),
      places(2, 7, {ClosureReason::kOneAxis, ClosureAxes::kY})};
  // Open along the map's x.
  const double heading_rad = mounted.graph.T_map_node[2].theta_rad;
  compared[2].information = without_direction(compared[2].information,
                                              {std::cos(heading_rad), -std::sin(heading_rad), 0.0});
  for (const std::size_t k : {0U, 2U}) {
    Constraint constraint = closure_constraint(compared[k]);
    constraint.weight = k == 0 ? 0.75 : 0.25;
    constraint.source = k;
    mounted.graph.constraints.push_back(constraint);
  }
  const auto closures = mapped_closures(mounted.track, compared, mounted.graph);
  ASSERT_EQ(closures.size(), 3U);
  const std::vector<double> weights = {0.75, 0.0, 0.25};
  for (std::size_t k = 0; k < 3; ++k) {
    const Scan& scan_i = *mounted.track.keyframes[compared[k].from]->scan;
    const Scan& scan_j = *mounted.track.keyframes[compared[k].to]->scan;
    EXPECT_EQ(closures[k].scan_i, 10 * compared[k].from);
    EXPECT_EQ(closures[k].scan_j, 10 * compared[k].to);
    EXPECT_EQ(closures[k].closure.stamp_i, scan_i.stamp);
    EXPECT_EQ(closures[k].closure.stamp_j, scan_j.stamp);
    EXPECT_EQ(closures[k].closure.weight, weights[k]);
    EXPECT_EQ(closures[k].closure.is_accepted, k != 1);
    EXPECT_EQ(closures[k].closure.axes, compared[k].verdict.axes);
    EXPECT_EQ(closures[k].closure.reason, to_string(compared[k].verdict.reason));
    EXPECT_THAT(scan_i.T_base_sensor.inverse() * closures[k].closure.T_i_j * scan_j.T_base_sensor,
                PoseNear(compared[k].T_from_to, PoseTolerance{}));
  }
}

TEST(MappedClosures, NameTheAxisOfTheFinalMap) {
  // Judged in a map that has turned since.
  MountedTrack mounted(4);
  for (const double open_rad : {0.0, 0.5 * kPi, kPi, -0.5 * kPi, 0.3, 1.3}) {
    ComparedPlaces compared = places(1, 3, {ClosureReason::kOneAxis, ClosureAxes::kX});
    const double in_sensor_rad = open_rad - mounted.graph.T_map_node[1].theta_rad;
    compared.information = without_direction(
        compared.information, {std::cos(in_sensor_rad), std::sin(in_sensor_rad), 0.0});
    PoseGraph graph = mounted.graph;
    graph.constraints.push_back(closure_constraint(compared));
    const auto closures = mapped_closures(mounted.track, {{compared}}, graph);
    const bool is_open_along_x = std::abs(std::cos(open_rad)) > 0.8;
    EXPECT_EQ(closures.at(0).closure.axes, is_open_along_x ? ClosureAxes::kY : ClosureAxes::kX)
        << open_rad;
  }
}

TEST(PiecesOfTrack, ShareOutAllScans) {
  MountedTrack mounted(6);  // Keyframes are the scans 0, 10, ... 50.
  mounted.track.pieces = {0, 0, 1, 1, 1, 2};
  const auto pieces = pieces_of(mounted.track, {true, false, true}, 58);
  ASSERT_EQ(pieces.size(), 3U);
  const std::vector<std::size_t> firsts = {0, 20, 50};
  const std::vector<std::size_t> nums = {20, 30, 8};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(pieces[k].first_scan, firsts[k]);
    EXPECT_EQ(pieces[k].num_scans, nums[k]);
    EXPECT_EQ(pieces[k].is_joined, k != 1);
  }
}

}  // namespace setsquare::map_assembly_test
