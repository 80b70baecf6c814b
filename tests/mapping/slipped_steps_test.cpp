// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Made-up drives there and back, over a few steps of which tracking slipped: by no scans.
#include "setsquare/mapping/slipped_steps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/graph/robust_pose_graph.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::slipped_steps_test {

using testing::uniform;

constexpr std::size_t kNumOut = 40;
constexpr std::size_t kNumNodes = 2 * kNumOut;
constexpr double kStep_m = 0.5;
constexpr double kStepSigma_m = 0.01;
constexpr double kMatchSigma_m = 0.03;

Eigen::Matrix3d information_of(double sigma_m) {
  const double per_m2 = 1.0 / (sigma_m * sigma_m);
  return Eigen::Vector3d(per_m2, per_m2, 1e4).asDiagonal();
}

/// Down a corridor and back, by keyframes of which the last steps before the turn slipped.
struct SlippedDrive {
  explicit SlippedDrive(std::mt19937_64& generator);

  /// Two keyframes where the truth has them, as a match would.
  [[nodiscard]] AuditMatch match_of(std::size_t from, std::size_t to) const;

  std::vector<Pose2> T_map_true;
  Eigen::Vector2d slip_m;  ///< How much too far tracking has all behind it.
  std::size_t first_slipped = 0;
  std::size_t last_slipped = 0;
  PoseGraph graph;  ///< The tracked steps.
  AuditFindings findings;
};

SlippedDrive::SlippedDrive(std::mt19937_64& generator) {
  for (std::size_t k = 0; k < kNumNodes; ++k) {
    const bool is_out = k < kNumOut;
    const double x_m = kStep_m * static_cast<double>(is_out ? k : kNumNodes - 1 - k);
    T_map_true.push_back({x_m, is_out ? 0.0 : 0.4, is_out ? 0.0 : kPi});
  }
  slip_m = {uniform(generator, 1.0, 2.0), uniform(generator, -0.1, 0.1)};
  first_slipped = 25 + generator() % 5;
  last_slipped = first_slipped + 4;
  std::normal_distribution<double> noise(0.0, kStepSigma_m);
  Pose2 tracked = T_map_true[0];
  graph.T_map_node.push_back(tracked);
  for (std::size_t k = 1; k < kNumNodes; ++k) {
    Pose2 step = T_map_true[k - 1].inverse() * T_map_true[k];
    step.x_m += noise(generator);
    step.y_m += noise(generator);
    if (k > first_slipped && k <= last_slipped) {
      step.x_m += 0.25 * slip_m.x();
      step.y_m += 0.25 * slip_m.y();
    }
    graph.constraints.push_back(
        {.from = k - 1, .to = k, .T_from_to = step, .information = information_of(kStepSigma_m)});
    tracked = tracked * step;
    graph.T_map_node.push_back(tracked);
  }
  for (std::size_t k = 0; k < kNumNodes; ++k) {
    findings.track.keyframes.push_back(k);
    findings.track.T_map_sensor.push_back(graph.T_map_node[k]);
    findings.track.way_m.push_back(kStep_m * static_cast<double>(k));
    findings.track.open_m2.push_back(0.0);
    findings.track.is_open.push_back(false);
  }
  // The way back from behind the slip meets the way there before it: both sides have matches.
  for (std::size_t to = kNumNodes - 20; to < kNumNodes; to += 3) {
    findings.matches.push_back(match_of(kNumNodes - 1 - to, to));
  }
  findings.groups = contradiction_groups(findings.matches, findings.track, {});
}

AuditMatch SlippedDrive::match_of(std::size_t from, std::size_t to) const {
  return {{from, to}, T_map_true[from].inverse() * T_map_true[to], information_of(kMatchSigma_m)};
}

/// The graph with the matches as closures, solved; how many of them are outvoted.
std::size_t num_outvoted(PoseGraph& graph, const AuditFindings& findings) {
  for (const MapHypothesis& told : findings.hypotheses()) {
    graph.constraints.push_back({.from = told.keyframe_from,
                                 .to = told.keyframe_to,
                                 .T_from_to = told.T_from_to,
                                 .information = told.information,
                                 .kind = ConstraintKind::kLoopClosure});
  }
  solve_robustly(graph, {}, {});
  return static_cast<std::size_t>(std::ranges::count_if(graph.constraints, [](const Constraint& c) {
    return c.kind == ConstraintKind::kLoopClosure && c.weight < 0.5;
  }));
}

TEST(SlippedSteps, AGroupOfContradictionsTellsBetweenWhichKeyframesTrackingSlipped) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 20; ++trial) {
    const SlippedDrive drive(generator);
    const Slips slips = slipped_steps(drive.findings, drive.graph);
    ASSERT_EQ(slips.size(), 1U);
    EXPECT_LE(slips[0].first, drive.first_slipped);
    EXPECT_GE(slips[0].last, drive.last_slipped);
  }
}

/// Without the rule closures are outvoted, by steps that are too sure of themselves.
TEST(SlippedSteps, ThenTheClosuresHoldAndTheDriveLiesWhereItWas) {
  auto generator = testing::make_generator();
  std::size_t num_outvoted_without = 0;
  for (int trial = 0; trial < 20; ++trial) {
    SCOPED_TRACE(trial);
    const SlippedDrive drive(generator);
    PoseGraph as_tracked = drive.graph;
    num_outvoted_without += num_outvoted(as_tracked, drive.findings);

    PoseGraph loosened = drive.graph;
    loosen_slipped(slipped_steps(drive.findings, drive.graph), loosened);
    EXPECT_EQ(num_outvoted(loosened, drive.findings), 0U);
    for (std::size_t k = kNumNodes - 20; k < kNumNodes; ++k) {
      const Eigen::Vector2d off_m =
          loosened.T_map_node[k].translation() - drive.T_map_true[k].translation();
      EXPECT_LT(off_m.norm(), 0.25) << k;
    }
  }
  EXPECT_GT(num_outvoted_without, 20U) << "the rule switched off";
}

TEST(SlippedSteps, TheCorrectionIsOneDeviationOfTheLoosenedSteps) {
  auto generator = testing::make_generator();
  const SlippedDrive drive(generator);
  const Slips slips = slipped_steps(drive.findings, drive.graph);
  ASSERT_EQ(slips.size(), 1U);
  PoseGraph loosened = drive.graph;
  loosen_slipped(slips, loosened);
  double variance_m2 = 0.0;
  for (std::size_t k = slips[0].first; k < slips[0].last; ++k) {
    variance_m2 += 1.0 / loosened.constraints[k].information(0, 0);
  }
  EXPECT_NEAR(std::sqrt(variance_m2), drive.slip_m.norm(), 0.2 * drive.slip_m.norm());
  EXPECT_EQ(loosened.constraints[0].information, drive.graph.constraints[0].information);
  EXPECT_EQ(loosened.constraints.back().information, drive.graph.constraints.back().information);
}

TEST(SlippedSteps, OfTwoSlipsTheGreaterCounts) {
  auto generator = testing::make_generator();
  const SlippedDrive drive(generator);
  PoseGraph loosened = drive.graph;
  loosen_slipped({{10, 20, 4.0}, {15, 30, 9.0}}, loosened);
  const auto times = [&](std::size_t k) {
    return drive.graph.constraints[k - 1].information(0, 0) /
           loosened.constraints[k - 1].information(0, 0);
  };
  EXPECT_NEAR(times(10), 1.0, 1e-12);
  EXPECT_NEAR(times(11), 4.0, 1e-12);
  EXPECT_NEAR(times(16), 9.0, 1e-12);
  EXPECT_NEAR(times(30), 9.0, 1e-12);
  EXPECT_NEAR(times(31), 1.0, 1e-12);
}

/// What a second audit finds is measured against what the first one loosened.
TEST(SlippedSteps, ALaterSlipComesOnTop) {
  auto generator = testing::make_generator();
  const SlippedDrive drive(generator);
  PoseGraph loosened = drive.graph;
  loosen_slipped({{10, 20, 4.0}}, loosened);
  loosen_slipped({{10, 20, 3.0}}, loosened);
  EXPECT_NEAR(
      drive.graph.constraints[14].information(0, 0) / loosened.constraints[14].information(0, 0),
      12.0,
      1e-9);
}

TEST(SlippedSteps, WhereNothingContradictsTheMapNothingSlipped) {
  auto generator = testing::make_generator();
  SlippedDrive drive(generator);
  drive.findings.groups.clear();
  EXPECT_TRUE(slipped_steps(drive.findings, drive.graph).empty());
}

}  // namespace setsquare::slipped_steps_test
