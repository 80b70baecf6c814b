// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/spread_graph.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/graph/marginal_covariance.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::spread_graph_test {

constexpr std::size_t kFirstOpen = 8;
constexpr std::size_t kNumOpen = 10;
constexpr std::size_t kNumBehind = 4;
constexpr std::size_t kNumScans = kFirstOpen + kNumOpen + kNumBehind;
constexpr double kSureHeading_rad = rad_from_deg(0.5);

/// Of the position's covariance, sigma along a direction.
double sigma_along_m(const Eigen::Matrix2d& covariance_m2, const Eigen::Vector2d& along) {
  return std::sqrt(along.dot(covariance_m2 * along)) / along.norm();
}

Eigen::Vector2d turned_left(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }

Constraint constraint_between(const std::vector<Pose2>& poses,
                              std::size_t from,
                              std::size_t to,
                              ConstraintKind kind) {
  Constraint constraint;
  constraint.from = from;
  constraint.to = to;
  constraint.T_from_to = poses[from].inverse() * poses[to];
  constraint.information = Eigen::Vector3d(1e6, 1e6, 1e7).asDiagonal();
  constraint.kind = kind;
  return constraint;
}

/// A drive from square walls into a round hall about `middle_m` and out to square walls again.
/// Every scan is a keyframe whose heading was measured, those in the hall by chance. From scan to
/// scan in the hall the turn may be off by `step_rad`.
struct HallDrive {
  explicit HallDrive(double step_rad);

  [[nodiscard]] double heading_sigma_rad(std::size_t node) const {
    return std::sqrt(MarginalCovariance(spread_graph(map)).of_heading(node));
  }

  Eigen::Vector2d middle_m;
  Map map;
};

HallDrive::HallDrive(double step_rad) {
  std::mt19937_64 generator = testing::make_generator();
  middle_m = {testing::uniform(generator, 3.0, 5.0), testing::uniform(generator, -3.0, 3.0)};
  Pose2 pose;
  for (std::size_t i = 0; i < kNumScans; ++i) {
    const bool is_open = i >= kFirstOpen && i < kFirstOpen + kNumOpen;
    MappedScan scan;
    scan.T_map_base = scan.T_map_sensor = pose;
    if (is_open) {
      scan.status = TrackStatus::kDegenerate;
      scan.is_turn_open = true;
      scan.open_turn_sigma_rad = step_rad;
      scan.open_turn_motion_m = turned_left(pose.translation() - middle_m);
    }
    map.scans.push_back(scan);
    map.keyframes.push_back(i);
    map.graph.T_map_node.push_back(pose);
    map.graph.headings.push_back({i, pose.theta_rad, 1.0 / (kSureHeading_rad * kSureHeading_rad)});
    pose =
        pose *
        Pose2{testing::uniform(generator, 0.2, 0.5), 0.0, testing::uniform(generator, -0.3, 0.3)};
  }
  for (std::size_t i = 1; i < kNumScans; ++i) {
    map.graph.constraints.push_back(
        constraint_between(map.graph.T_map_node, i - 1, i, ConstraintKind::kOdometry));
  }
  map.pieces = {{0, kNumScans, true}};
}

TEST(SpreadGraph, WithoutAnOpenTurnNothingChanges) {
  HallDrive drive(0.0);
  for (MappedScan& scan : drive.map.scans) scan.is_turn_open = false;
  drive.map.graph.constraints.push_back(constraint_between(
      drive.map.graph.T_map_node, 2, kFirstOpen + 2, ConstraintKind::kLoopClosure));
  const PoseGraph spread = spread_graph(drive.map);
  const PoseGraph& graph = drive.map.graph;
  ASSERT_EQ(spread.constraints.size(), graph.constraints.size());
  for (std::size_t i = 0; i < graph.constraints.size(); ++i) {
    EXPECT_EQ(spread.constraints[i].information, graph.constraints[i].information) << i;
    EXPECT_EQ(spread.constraints[i].to, graph.constraints[i].to) << i;
  }
  EXPECT_EQ(spread.headings.size(), graph.headings.size());
}

TEST(SpreadGraph, AStepThatNothingSecondsMayBeAWrongOneUntilAClosureTells) {
  HallDrive drive(0.0);
  for (MappedScan& scan : drive.map.scans) scan.is_turn_open = false;
  const std::size_t wrong = kFirstOpen;
  const std::size_t last = kNumScans - 1;
  const auto sigmas = [&](std::span<const std::size_t> unseconded, std::size_t node) {
    const MarginalCovariance marginals(spread_graph(drive.map, unseconded));
    return std::pair{sigma_along_m(marginals.of_way(0, node), {1.0, 0.0}),
                     std::sqrt(marginals.of_heading(node))};
  };
  const std::size_t steps[] = {wrong};
  EXPECT_LT(sigmas({}, last).first, 0.1);
  EXPECT_LT(sigmas(steps, wrong - 1).first, 0.5 * sigmas(steps, wrong).first);
  EXPECT_GT(sigmas(steps, last).first, 1.5);
  // Of the two sides of the step one holds the headings.
  EXPECT_GT(std::max(sigmas(steps, 0).second, sigmas(steps, last).second), rad_from_deg(15.0));
  drive.map.track.motions.resize(kNumScans);
  drive.map.odometry.verdict = OdometryVerdict::kBelieved;
  EXPECT_GT(sigmas(steps, last).first, 0.25);
  EXPECT_LT(sigmas(steps, last).first, 1.0);
  drive.map.track.motions[wrong].covariance.has_odometry = false;
  EXPECT_GT(sigmas(steps, last).first, 1.5);
  const auto close = [&](std::size_t from, std::size_t to) {
    drive.map.graph.constraints.push_back(
        constraint_between(drive.map.graph.T_map_node, from, to, ConstraintKind::kLoopClosure));
  };
  // Found where the step led, right or wrong.
  close(wrong - 1, wrong + 1);
  EXPECT_GT(sigmas(steps, last).first, 1.5);
  close(2, last);
  EXPECT_LT(sigmas(steps, last).first, 0.1);
}

TEST(SpreadGraph, AStepThatDepartsFromTheOdometryMayBeOffByAsMuch) {
  HallDrive drive(0.0);
  for (MappedScan& scan : drive.map.scans) scan.is_turn_open = false;
  drive.map.graph.headings.clear();
  drive.map.graph.headings.push_back({0, 0.0, 1.0 / (kSureHeading_rad * kSureHeading_rad)});
  drive.map.track.motions.resize(kNumScans);
  const auto spread_at = [&](std::size_t node) {
    const MarginalCovariance marginals(spread_graph(drive.map));
    return std::pair{sigma_along_m(marginals.of_way(0, node), {1.0, 0.0}),
                     std::sqrt(marginals.of_heading(node))};
  };
  const auto usual = spread_at(kFirstOpen);
  MotionCovariance& motion = drive.map.track.motions[kFirstOpen].covariance;
  motion.departure_sigma_m = 0.4;
  motion.departure_sigma_rad = 0.2;
  const auto departed = spread_at(kFirstOpen);
  EXPECT_NEAR(departed.first, std::hypot(usual.first, 0.4), 1e-6);
  EXPECT_NEAR(departed.second, std::hypot(usual.second, 0.2), 1e-6);
}

TEST(SpreadGraph, InABuildingOfWingsWallsTellNoHeadingBehindATurnThatIsNoSurer) {
  HallDrive drive(0.0);
  for (MappedScan& scan : drive.map.scans) scan.is_turn_open = false;
  drive.map.track.motions.resize(kNumScans);
  drive.map.track.motions[kFirstOpen].covariance.departure_sigma_rad = rad_from_deg(4.0);
  const auto largest_sigma_rad = [&] {
    const MarginalCovariance marginals(spread_graph(drive.map));
    double largest_rad2 = 0.0;
    for (std::size_t k = 0; k < kNumScans; ++k) {
      largest_rad2 = std::max(largest_rad2, marginals.of_heading(k));
    }
    return std::sqrt(largest_rad2);
  };
  const auto building_of = [&](double angle_rad, double support) {
    drive.map.frames = {{.support = 20.0}, {.offset_rad = angle_rad, .support = support}};
  };
  EXPECT_LT(largest_sigma_rad(), kSureHeading_rad) << "a quarter turn is more than that";
  for (const double angle_deg : {10.0, -10.0, 80.0, 100.0}) {
    building_of(rad_from_deg(angle_deg), 20.0);
    EXPECT_GT(largest_sigma_rad(), rad_from_deg(4.0)) << angle_deg;
    building_of(rad_from_deg(angle_deg), 2.0);
    EXPECT_LT(largest_sigma_rad(), kSureHeading_rad) << "seen by two keyframes";
  }
  building_of(rad_from_deg(30.0), 20.0);
  EXPECT_LT(largest_sigma_rad(), kSureHeading_rad) << "a turn of 4 degrees cannot be one of 30";
  building_of(rad_from_deg(10.0), 20.0);
  drive.map.graph.constraints.push_back(constraint_between(
      drive.map.graph.T_map_node, 2, kNumScans - 1, ConstraintKind::kLoopClosure));
  EXPECT_LT(largest_sigma_rad(), rad_from_deg(4.0)) << "a closure tells";
}

TEST(SpreadGraph, InAnOpenRunSigmasOfTurnsAddUp) {
  const double step_rad = 0.1;
  const HallDrive drive(step_rad);
  for (std::size_t k = 0; k < kNumOpen; ++k) {
    const double sum_rad = step_rad * static_cast<double>(k + 1);
    EXPECT_NEAR(drive.heading_sigma_rad(kFirstOpen + k), sum_rad, 0.02 * sum_rad) << k;
  }
  EXPECT_LT(drive.heading_sigma_rad(kFirstOpen - 1), kSureHeading_rad);
  // What the graph that serves the poses says.
  const MarginalCovariance without(drive.map.graph);
  EXPECT_LT(std::sqrt(without.of_heading(kFirstOpen + kNumOpen - 1)), kSureHeading_rad);
}

TEST(SpreadGraph, APositionInTheHallIsOffByTheTurnTimesTheDistanceToTheMiddle) {
  const double step_rad = 0.1;
  const HallDrive drive(step_rad);
  const std::size_t last = kFirstOpen + kNumOpen - 1;
  const Eigen::Vector2d from_middle_m =
      drive.map.graph.T_map_node[last].translation() - drive.middle_m;
  const MarginalCovariance marginals(spread_graph(drive.map));
  const double lever_m = from_middle_m.norm();
  const double sum_rad = step_rad * static_cast<double>(kNumOpen);
  ASSERT_GT(lever_m, 0.3);
  EXPECT_NEAR(sigma_along_m(marginals.of_way(0, last), turned_left(from_middle_m)),
              sum_rad * lever_m,
              0.05 * sum_rad * lever_m);
  // Walls bind the distance to the middle, whatever the heading.
  EXPECT_LT(sigma_along_m(marginals.of_way(0, last), from_middle_m), 0.05 * sum_rad * lever_m);
  const MarginalCovariance without(drive.map.graph);
  EXPECT_LT(sigma_along_m(without.of_way(0, last), turned_left(from_middle_m)),
            0.1 * sum_rad * lever_m);
}

TEST(SpreadGraph, ATurnThatIsLostStaysLostBehindTheHall) {
  const double step_rad = 0.1;
  const HallDrive drive(step_rad);
  const double sum_rad = step_rad * static_cast<double>(kNumOpen);
  EXPECT_NEAR(drive.heading_sigma_rad(kNumScans - 1), sum_rad, 0.02 * sum_rad);
  for (const HeadingMeasurement& heading : spread_graph(drive.map).headings) {
    EXPECT_LT(heading.node, kFirstOpen) << "the walls behind tell it modulo a quarter turn";
  }
}

TEST(SpreadGraph, HeadingsCountOnTheSideThatHasTheMostInformation) {
  HallDrive drive(0.1);
  for (HeadingMeasurement& heading : drive.map.graph.headings) {
    if (heading.node >= kFirstOpen + kNumOpen) heading.information_per_rad2 *= 10.0;
  }
  EXPECT_LT(drive.heading_sigma_rad(kNumScans - 1), kSureHeading_rad);
  EXPECT_GT(drive.heading_sigma_rad(kFirstOpen - 1), 0.5);
}

TEST(SpreadGraph, ATurnThatIsKnownToAFewDegreesIsMadeGoodByTheWallsBehind) {
  const double step_rad = rad_from_deg(1.0);
  const HallDrive drive(step_rad);
  EXPECT_LT(drive.heading_sigma_rad(kNumScans - 1), kSureHeading_rad);
  EXPECT_GT(drive.heading_sigma_rad(kFirstOpen + kNumOpen / 2), 3.0 * kSureHeading_rad);
  // Just beyond what makes a quarter turn sure.
  const HallDrive lost(rad_from_deg(1.6));
  EXPECT_GT(lost.heading_sigma_rad(kNumScans - 1), rad_from_deg(14.0));
}

TEST(SpreadGraph, AClosureOverTheHallMakesTheTurnGood) {
  HallDrive drive(0.1);
  EXPECT_GT(drive.heading_sigma_rad(kNumScans - 1), 0.5);
  drive.map.graph.constraints.push_back(constraint_between(
      drive.map.graph.T_map_node, 1, kNumScans - 2, ConstraintKind::kLoopClosure));
  EXPECT_LT(drive.heading_sigma_rad(kNumScans - 1), 2.0 * kSureHeading_rad);
}

TEST(SpreadGraph, AClosureOfAScanInTheHallTellsNothing) {
  HallDrive drive(0.1);
  const std::size_t last = kFirstOpen + kNumOpen - 1;
  const double before_rad = drive.heading_sigma_rad(last);
  const std::size_t num_before = spread_graph(drive.map).constraints.size();
  for (const std::size_t other : {std::size_t{1}, kFirstOpen + 1, kNumScans - 1}) {
    drive.map.graph.constraints.push_back(
        constraint_between(drive.map.graph.T_map_node, other, last, ConstraintKind::kLoopClosure));
  }
  EXPECT_EQ(spread_graph(drive.map).constraints.size(), num_before);
  EXPECT_EQ(drive.heading_sigma_rad(last), before_rad);
}

// A run ends at a scan that is bound, also where that is no keyframe: what was lost stays lost.
TEST(SpreadGraph, TwoRunsAreTwoErrors) {
  const double step_rad = 0.1;
  HallDrive drive(step_rad);
  const std::size_t middle = kFirstOpen + kNumOpen / 2;
  MappedScan& bound = drive.map.scans[middle];
  bound.is_turn_open = false;
  bound.open_turn_sigma_rad = 0.0;
  std::erase_if(drive.map.graph.headings, [&](const auto& heading) {
    return heading.node >= kFirstOpen;  // Walls that tell the turn, but not the building's.
  });
  const double first_rad = step_rad * 5.0;
  const double second_rad = step_rad * 4.0;
  EXPECT_NEAR(drive.heading_sigma_rad(middle), first_rad, 0.02);
  EXPECT_NEAR(drive.heading_sigma_rad(kNumScans - 1), std::hypot(first_rad, second_rad), 0.02);
}

TEST(SpreadGraph, AMapWithoutAGraphHasNone) {
  EXPECT_TRUE(spread_graph({}).T_map_node.empty());
  HallDrive drive(0.1);
  drive.map.keyframes.clear();  // By a mapper that keeps none: what there is stays.
  EXPECT_EQ(spread_graph(drive.map).headings.size(), drive.map.graph.headings.size());
}

}  // namespace setsquare::spread_graph_test
