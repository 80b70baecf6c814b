// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/heading_spread.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Cholesky>
#include <optional>
#include <random>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::heading_spread_test {

constexpr double kStep_m = 0.4;
constexpr double kStepSigma_rad = rad_from_deg(0.05);
constexpr double kOwnSigma_rad = rad_from_deg(0.1);
constexpr double kWallSigma_rad = rad_from_deg(0.4);

double normal(std::mt19937_64& generator, double sigma) {
  return std::normal_distribution<double>(0.0, sigma)(generator);
}

Constraint motion_to(std::size_t k, double turned_rad, double sigma_rad) {
  Constraint motion;
  motion.from = k - 1;
  motion.to = k;
  motion.T_from_to = {kStep_m, 0.0, turned_rad};
  motion.information(2, 2) = 1.0 / (sigma_rad * sigma_rad);
  return motion;
}

/// A track of which spread_headings() looks at nothing but how the motions were disturbed.
KeyframeTrack undisturbed_track(std::size_t size) {
  KeyframeTrack track;
  track.motions.resize(size);
  track.pieces.assign(size, 0);
  return track;
}

/// A corridor of walls, each 2.5 m long and off square by its own error, driven along several times
/// there and back. A keyframe measures its heading, which is 0, by the wall beside it. Motions that
/// were tracked are right to `kStepSigma_rad`, as stated, and so are closures with the first pass.
struct Corridor {
  static constexpr std::size_t kNumSteps = 40;

  Corridor(std::size_t num_passes, std::mt19937_64& generator) {
    std::vector<double> walls_rad;
    const auto wall_at = [&](double x_m) {
      const auto wall = static_cast<std::size_t>(x_m / 2.5);
      while (walls_rad.size() <= wall) walls_rad.push_back(normal(generator, kWallSigma_rad));
      return walls_rad[wall];
    };
    const double variance = kOwnSigma_rad * kOwnSigma_rad + kWallSigma_rad * kWallSigma_rad;
    for (std::size_t k = 0; k < num_passes * kNumSteps; ++k) {
      const std::size_t pass = k / kNumSteps;
      const std::size_t along = pass % 2 == 0 ? k % kNumSteps : kNumSteps - 1 - k % kNumSteps;
      const double x_m = static_cast<double>(along) * kStep_m;
      graph.T_map_node.push_back({x_m, 0.0, 0.0});
      graph.headings.push_back(
          {k, wall_at(x_m) + normal(generator, kOwnSigma_rad), 1.0 / variance});
      if (k > 0) {
        graph.constraints.push_back(
            motion_to(k, normal(generator, kStepSigma_rad), kStepSigma_rad));
      }
      if (pass == 0) continue;
      graph.constraints.push_back(motion_to(k, normal(generator, kStepSigma_rad), kStepSigma_rad));
      graph.constraints.back().from = along;
      graph.constraints.back().kind = ConstraintKind::kLoopClosure;
    }
  }

  /// The rule, or in place of it the same number of keyframes for all.
  void spread(std::optional<double> num_alike) {
    const std::size_t n = graph.T_map_node.size();
    if (!num_alike) {
      spread_headings(
          undisturbed_track(n), {}, std::vector<double>(n, 1.0), {.num_assumed = 1e9}, graph);
      return;
    }
    for (HeadingMeasurement& heading : graph.headings) heading.information_per_rad2 /= *num_alike;
  }

  PoseGraph graph;
};

/// The plain twin: the normal equations of the headings alone, dense.
struct DenseHeadings {
  explicit DenseHeadings(const PoseGraph& graph) {
    const auto n = static_cast<Eigen::Index>(graph.T_map_node.size());
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
    for (const HeadingMeasurement& heading : graph.headings) {
      const auto k = static_cast<Eigen::Index>(heading.node);
      information(k, k) += heading.information_per_rad2;
      right(k) += heading.information_per_rad2 * heading.heading_rad;
    }
    for (const Constraint& motion : graph.constraints) {
      const auto a = static_cast<Eigen::Index>(motion.from);
      const auto b = static_cast<Eigen::Index>(motion.to);
      const double weight = motion.information(2, 2);
      information(a, a) += weight;
      information(b, b) += weight;
      information(a, b) -= weight;
      information(b, a) -= weight;
      right(a) -= weight * motion.T_from_to.theta_rad;
      right(b) += weight * motion.T_from_to.theta_rad;
    }
    covariance = information.llt().solve(Eigen::MatrixXd::Identity(n, n));
    heading_rad = covariance * right;
  }

  Eigen::MatrixXd covariance;
  Eigen::VectorXd heading_rad;
};

/// Mean square of the headings' errors over their stated variances, of many corridors.
double normalised_square(std::optional<double> num_alike) {
  std::mt19937_64 generator = testing::make_generator();
  constexpr int kNumCorridors = 40;
  double sum = 0.0;
  for (int i = 0; i < kNumCorridors; ++i) {
    Corridor corridor(6, generator);
    corridor.spread(num_alike);
    const DenseHeadings dense(corridor.graph);
    const Eigen::ArrayXd squares =
        dense.heading_rad.array().square() / dense.covariance.diagonal().array();
    sum += squares.mean() / kNumCorridors;
  }
  return sum;
}

TEST(HeadingSpread, StatedSpreadsAreThoseOfTheErrorsWhereWallsAreSeenOnSeveralPasses) {
  const double stated = normalised_square({});
  EXPECT_LT(stated, 1.2);
  EXPECT_GT(stated, 0.3);
  // The rule switched off: neighbours count as a sixth each, and each keyframe counts alone.
  EXPECT_GT(normalised_square(6.0), 2.0 * stated);
  EXPECT_GT(normalised_square(1.0), 5.0 * stated);
}

/// A drive from one wing to another one, whose offset is known by the tracked rotation at the joint
/// alone: all that its walls measure is off by the error of that.
struct TwoWings {
  static constexpr std::size_t kPerWing = 40;
  static constexpr double kJointSigma_rad = rad_from_deg(0.8);

  explicit TwoWings(std::mt19937_64& generator) {
    const double off_rad = normal(generator, kJointSigma_rad);
    headings.frames = {{}, {.offset_rad = 0.3, .sigma_rad = kJointSigma_rad}};
    for (std::size_t k = 0; k < 2 * kPerWing; ++k) {
      const bool is_second = k >= kPerWing;
      const double shared_rad = is_second ? off_rad : 0.0;
      graph.T_map_node.push_back({static_cast<double>(k) * kStep_m, 0.0, 0.0});
      graph.headings.push_back({k,
                                shared_rad + normal(generator, kOwnSigma_rad),
                                1.0 / (kOwnSigma_rad * kOwnSigma_rad)});
      headings.frame.push_back(is_second ? 1 : 0);
      if (k == 0) continue;
      const bool is_joint = k == kPerWing;
      const double sigma_rad = is_joint ? kJointSigma_rad : kStepSigma_rad;
      const double turned_rad = is_joint ? off_rad : normal(generator, kStepSigma_rad);
      graph.constraints.push_back(motion_to(k, turned_rad, sigma_rad));
    }
  }

  PoseGraph graph;
  FusedHeadings headings;
};

/// Mean square of the second wing's headings' errors over their stated variances, of many logs.
double normalised_square_of_wing(bool shares_offset) {
  std::mt19937_64 generator = testing::make_generator();
  constexpr int kNumLogs = 200;
  double sum = 0.0;
  for (int i = 0; i < kNumLogs; ++i) {
    TwoWings wings(generator);
    if (shares_offset) share_frame_offsets(wings.headings, 1.0, wings.graph);
    const DenseHeadings dense(wings.graph);
    const Eigen::ArrayXd squares =
        dense.heading_rad.array().square() / dense.covariance.diagonal().array();
    sum += squares.tail(TwoWings::kPerWing).mean() / kNumLogs;
  }
  return sum;
}

TEST(HeadingSpread, AWingIsTurnedAsAWholeByWhatItsOffsetIsOff) {
  EXPECT_LT(normalised_square_of_wing(true), 2.5);
  EXPECT_GT(normalised_square_of_wing(true), 0.5);
  EXPECT_GT(normalised_square_of_wing(false), 10.0) << "the rule switched off";
}

TEST(HeadingSpread, TheMainFrameIsAsCertainAsBefore) {
  std::mt19937_64 generator = testing::make_generator();
  TwoWings wings(generator);
  const double before = wings.graph.headings[3].information_per_rad2;
  share_frame_offsets(wings.headings, 4.0, wings.graph);
  EXPECT_DOUBLE_EQ(wings.graph.headings[3].information_per_rad2, before);
  EXPECT_LT(wings.graph.headings[TwoWings::kPerWing].information_per_rad2, 0.1 * before);
}

/// Variance in the middle of a corridor.
double variance_in_the_middle(std::size_t num_passes, std::optional<double> num_alike) {
  std::mt19937_64 generator = testing::make_generator();
  Corridor corridor(num_passes, generator);
  corridor.spread(num_alike);
  constexpr auto kMiddle = static_cast<Eigen::Index>(Corridor::kNumSteps / 2);
  return DenseHeadings(corridor.graph).covariance(kMiddle, kMiddle);
}

TEST(HeadingSpread, MorePassesTellHardlyMoreOfAWall) {
  EXPECT_GT(variance_in_the_middle(8, {}), 0.5 * variance_in_the_middle(1, {}));
  EXPECT_LT(variance_in_the_middle(8, 6.0), 0.3 * variance_in_the_middle(1, 6.0));  // Without it.
}

TEST(HeadingSpread, CountsTheKeyframesThatAPlainSumCounts) {
  std::mt19937_64 generator = testing::make_generator();
  PoseGraph graph;
  std::vector<double> shares;
  for (std::size_t k = 0; k < 200; ++k) {
    graph.T_map_node.push_back(
        {testing::uniform(generator, -6.0, 6.0), testing::uniform(generator, -6.0, 6.0), 0.0});
    shares.push_back(testing::uniform(generator, 0.3, 1.0));
    if (k % 5 != 0) graph.headings.push_back({k, 0.0, testing::uniform(generator, 1.0, 9.0)});
  }
  for (const double same_walls_m : {0.3, 1.0, 4.0}) {
    const std::vector<double> counted = keyframes_of_same_walls(graph, shares, same_walls_m);
    ASSERT_EQ(counted.size(), graph.headings.size());
    for (std::size_t m = 0; m < counted.size(); ++m) {
      const HeadingMeasurement& heading = graph.headings[m];
      double expected = 0.0;
      for (const HeadingMeasurement& other : graph.headings) {
        const double d_m = (graph.T_map_node[other.node].translation() -
                            graph.T_map_node[heading.node].translation())
                               .norm();
        if (d_m > 3.0 * same_walls_m) continue;
        expected += shares[other.node] *
                    std::exp(-d_m * d_m / (2.0 * same_walls_m * same_walls_m)) *
                    std::min(1.0, other.information_per_rad2 / heading.information_per_rad2);
      }
      EXPECT_NEAR(counted[m], expected, 1e-9);
      EXPECT_GE(counted[m], shares[heading.node] - 1e-12);
    }
  }
}

TEST(HeadingSpread, ScannersAtOnePlaceCountAsOneKeyframe) {
  PoseGraph graph;
  graph.T_map_node.assign(4, {1.0, 2.0, 0.0});
  for (std::size_t k = 0; k < 4; ++k) graph.headings.push_back({k, 0.0, 25.0});
  const std::vector<double> shares(4, 0.25);
  for (const double num : keyframes_of_same_walls(graph, shares, 1.0)) EXPECT_NEAR(num, 1.0, 1e-12);
}

/// A straight drive whose tracked rotations registration changed by so much.
PoseGraph changed_drive(std::size_t num_steps, double change_rad, std::mt19937_64& generator) {
  PoseGraph graph;
  graph.T_map_node.push_back({});
  for (std::size_t k = 1; k <= num_steps; ++k) {
    const double turned_rad = testing::uniform(generator, -0.3, 0.3);
    graph.constraints.push_back(motion_to(k, turned_rad, kStepSigma_rad));
    const Pose2& before = graph.T_map_node.back();
    graph.T_map_node.push_back(
        {before.x_m + kStep_m,
         0.0,
         wrap_to_pi(before.theta_rad + turned_rad + normal(generator, change_rad))});
  }
  return graph;
}

TEST(HeadingSpread, RotationsAreAsUncertainAsRegistrationShowsThem) {
  std::mt19937_64 generator = testing::make_generator();
  const HeadingSpreadParams params{.max_changes = 100.0, .num_assumed = 0.0};
  for (const double change : {0.1, 0.5, 2.0}) {
    const PoseGraph graph = changed_drive(2000, change * kStepSigma_rad, generator);
    const double expected = std::pow(params.sigma_per_change * change, 2);
    EXPECT_NEAR(
        rotation_variance_scale(undisturbed_track(2001), graph, params) / expected, 1.0, 0.15);
  }
}

TEST(HeadingSpread, OfAShortLogNothingIsSaid) {
  std::mt19937_64 generator = testing::make_generator();
  const HeadingSpreadParams params;
  EXPECT_DOUBLE_EQ(rotation_variance_scale(undisturbed_track(1), {}, params), 1.0);
  const PoseGraph graph = changed_drive(2, 0.0, generator);
  const double scale = rotation_variance_scale(undisturbed_track(3), graph, params);
  EXPECT_NEAR(scale, params.num_assumed / (params.num_assumed + 2.0), 1e-9);
}

TEST(HeadingSpread, OneSlipIsNotTheScannersNoise) {
  std::mt19937_64 generator = testing::make_generator();
  PoseGraph graph = changed_drive(200, 0.1 * kStepSigma_rad, generator);
  const double before = rotation_variance_scale(undisturbed_track(201), graph, {});
  graph.constraints[99].T_from_to.theta_rad += 0.2;
  EXPECT_LT(rotation_variance_scale(undisturbed_track(201), graph, {}), before + 0.5);
}

TEST(HeadingSpread, DisturbedMotionsAreNotJudgedAndNeverMoreCertain) {
  std::mt19937_64 generator = testing::make_generator();
  for (const double change : {0.05, 3.0}) {
    PoseGraph graph = changed_drive(300, change * kStepSigma_rad, generator);
    KeyframeTrack track = undisturbed_track(301);
    track.motions[7].slip_sigma_m = 0.3;
    for (std::size_t k = 200; k <= 300; ++k) track.pieces[k] = 1;
    const double stated = graph.constraints[6].information(2, 2);
    const double of_joint = graph.constraints[199].information(2, 2);
    spread_headings(track, {}, std::vector<double>(301, 1.0), {}, graph);
    EXPECT_LE(graph.constraints[6].information(2, 2), stated);
    EXPECT_LE(graph.constraints[199].information(2, 2), of_joint);
    const bool is_surer = graph.constraints[5].information(2, 2) > stated;
    EXPECT_EQ(is_surer, change < 0.5);
  }
}

}  // namespace setsquare::heading_spread_test
