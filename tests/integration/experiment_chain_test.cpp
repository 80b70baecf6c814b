// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "experiments/chain_errors.hpp"
#include "experiments/circuit_study.hpp"
#include "experiments/full_mapper.hpp"
#include "experiments/scan_chain.hpp"

namespace setsquare::experiments::experiment_chain_test {

MatchResult answer(MatchStatus status, const Pose2& pose) {
  MatchResult result;
  result.status = status;
  result.T_reference_current = pose;
  return result;
}

const Pose2 kLast{0.4, 0.0, 0.0};

TEST(MotionFrom, AMatchedAnswerIsTaken) {
  const Pose2 pose{0.3, 0.1, 0.2};
  EXPECT_EQ(motion_from(answer(MatchStatus::kMatched, pose), kLast), pose);
}

TEST(MotionFrom, ACorridorKeepsTheLastMotionAlongAndTheAnswerAcross) {
  MatchResult result = answer(MatchStatus::kDegenerate, {5.0, 0.1, 0.02});
  result.degenerate_direction_rad = 0.0;
  const Pose2 motion = motion_from(result, kLast);
  EXPECT_NEAR(motion.x_m, 0.4, 1e-12);
  EXPECT_NEAR(motion.y_m, 0.1, 1e-12);
  EXPECT_EQ(motion.theta_rad, 0.02);
}

TEST(MotionFrom, OfTwoPosesTheOneNearerToTheLastMotion) {
  MatchResult result = answer(MatchStatus::kAmbiguous, {2.4, 0.0, 0.0});
  result.runner_up = RunnerUp{{0.41, 0.0, 0.0}, 0.5};
  EXPECT_EQ(motion_from(result, kLast).x_m, 0.41);
  result.runner_up->T_reference_current.x_m = -3.0;
  EXPECT_EQ(motion_from(result, kLast).x_m, 2.4);
}

TEST(MotionFrom, WithoutAPoseTheLastMotion) {
  MatchResult result;
  result.status = MatchStatus::kNoOverlap;
  EXPECT_EQ(motion_from(result, kLast), kLast);
}

TEST(TranslationGivenTurn, IsWhereTheCostIsLeast) {
  MatchResult result = answer(MatchStatus::kMatched, {0.4, 0.1, 0.02});
  result.information.setZero();
  result.information(0, 0) = 4e4;
  result.information(1, 1) = 1e4;
  result.information(2, 2) = 3e5;
  result.information(1, 2) = result.information(2, 1) = 5e4;
  const double turn_rad = 0.03;
  const Eigen::Vector2d best =
      translation_given_turn(result, *result.T_reference_current, turn_rad);
  const auto cost = [&](const Eigen::Vector2d& p) {
    const Eigen::Vector3d e(p.x() - 0.4, p.y() - 0.1, turn_rad - 0.02);
    return e.dot(result.information * e);
  };
  EXPECT_NEAR(best.y(), 0.1 - 5.0 * 0.01, 1e-12);
  for (const double step : {-1e-3, 1e-3}) {
    EXPECT_GT(cost(best + Eigen::Vector2d(step, 0.0)), cost(best));
    EXPECT_GT(cost(best + Eigen::Vector2d(0.0, step)), cost(best));
  }
}

/// Round a square of 20 m, a pose every metre.
std::vector<Pose2> square_track(double axis_rad) {
  std::vector<Pose2> track = {{1.0, 2.0, axis_rad}};
  for (int side = 0; side < 4; ++side) {
    for (int i = 0; i < 20; ++i) track.push_back(track.back() * Pose2{1.0, 0.0, 0.0});
    track.push_back(track.back() * Pose2{0.0, 0.0, 0.5 * kPi});
  }
  return track;
}

TEST(ChainErrors, APerfectChainInAnotherFrameHasNone) {
  const double axis_rad = 0.3;
  const std::vector<Pose2> truth = square_track(axis_rad);
  const Pose2 T_building_map{-7.0, 3.0, 0.5 * kPi - axis_rad};
  std::vector<Pose2> chain;
  for (const Pose2& pose : truth) chain.push_back(T_building_map * pose);
  const std::vector<Pose2> placed = placed_at_truth(chain, truth, axis_rad);
  const HeadingErrors heading = heading_errors(placed, truth);
  EXPECT_LT(heading.highest_rad, 1e-9);
  EXPECT_EQ(heading.num_wrong_turns, 0U);
  EXPECT_LT(closure_error(placed, truth, 0, truth.size() - 1).norm(), 1e-9);
}

TEST(ChainErrors, AClosureErrorIsThatOfTheMap) {
  const std::vector<Pose2> truth = square_track(1.0);
  std::vector<Pose2> chain = truth;
  chain.back().x_m += 0.3;
  chain.back().y_m -= 0.8;
  const Eigen::Vector2d error_m = closure_error(chain, truth, 0, truth.size() - 1);
  EXPECT_NEAR(error_m.x(), 0.3, 1e-12);
  EXPECT_NEAR(error_m.y(), -0.8, 1e-12);
}

TEST(ChainErrors, AWrongQuarterTurnIsCountedAndIsNoneModulo90Deg) {
  const std::vector<Pose2> truth = square_track(0.0);
  std::vector<Pose2> chain = truth;
  for (std::size_t k = 30; k < chain.size(); ++k) chain[k].theta_rad += 0.5 * kPi;
  const HeadingErrors heading = heading_errors(chain, truth);
  EXPECT_EQ(heading.num_wrong_turns, 1U);
  EXPECT_NEAR(heading.end_rad, 0.5 * kPi, 1e-12);
  EXPECT_NEAR(heading.square_end_rad, 0.0, 1e-12);
}

TEST(ChainErrors, DriftOfTheHeadingIsItsSlope) {
  const std::vector<Pose2> truth = square_track(0.0);
  const std::vector<double> path_m = travelled_m(truth);
  std::vector<Pose2> chain = truth;
  for (std::size_t k = 0; k < chain.size(); ++k) chain[k].theta_rad += 1e-3 * path_m[k];
  EXPECT_NEAR(heading_errors(chain, truth).slope_rad_per_100_m, 0.1, 1e-9);
}

TEST(JudgeHeadings, NamesTheSeedsThatEndWrongly) {
  CircuitStudy study;
  study.runs.resize(3);
  for (std::size_t i = 0; i < study.runs.size(); ++i) study.runs[i].seed = i + 1;
  study.runs[0].paper.heading.end_rad = rad_from_deg(0.1);
  study.runs[1].paper.heading.end_rad = rad_from_deg(90.0);
  study.runs[1].paper.heading.num_wrong_turns = 3;
  study.runs[2].paper.heading.end_rad = rad_from_deg(0.4);
  study.runs[2].paper.heading.slope_rad_per_100_m = rad_from_deg(-0.2);
  const HeadingJudgement judgement = judge_headings(study, &CircuitRun::paper);
  EXPECT_NEAR(judgement.median_end_deg, 0.4, 1e-12);
  EXPECT_NEAR(judgement.worst_end_deg, 90.0, 1e-12);
  EXPECT_NEAR(judgement.median_slope_deg_per_100_m, 0.0, 1e-12);
  EXPECT_EQ(judgement.num_wrong_turns, 3U);
  ASSERT_EQ(judgement.failing.size(), 1U);
  EXPECT_EQ(judgement.failing.front()->seed, 2U);
  EXPECT_TRUE(judge_headings(study, &CircuitRun::paper_literal).failing.empty());
}

MappedClosure closure_between(std::size_t i, std::size_t j, const Pose2& T_i_j, ClosureAxes axes) {
  MappedClosure mapped;
  mapped.scan_i = i;
  mapped.scan_j = j;
  mapped.closure.T_i_j = T_i_j;
  mapped.closure.axes = axes;
  mapped.closure.is_accepted = true;
  mapped.closure.weight = 1.0;
  return mapped;
}

Map track_along(const std::vector<Pose2>& poses) {
  Map track;
  for (const Pose2& pose : poses) {
    MappedScan scan;
    scan.T_map_base = pose;
    track.scans.push_back(scan);
  }
  track.pieces.push_back({0, poses.size(), true});
  return track;
}

TEST(MapErrors, OfAMapInAnotherFrameAreThoseOfItsShape) {
  const std::vector<Pose2> truth = square_track(0.4);
  const Pose2 T_map_truth{3.0, -8.0, 2.0};
  std::vector<Pose2> poses;
  for (const Pose2& pose : truth) poses.push_back(T_map_truth * pose);
  MapErrors errors = map_errors(track_along(poses), truth);
  EXPECT_LT(errors.first_final_m, 1e-9);
  EXPECT_LT(errors.highest_m, 1e-9);
  EXPECT_LT(errors.heading_highest_rad, 1e-9);
  // A first pose that is off by its heading turns the map about itself, and no other error.
  poses.front().theta_rad += 0.01;
  errors = map_errors(track_along(poses), truth);
  EXPECT_GT(errors.first_mean_m, 0.05);
  EXPECT_LT(errors.highest_m, 1e-9);
}

TEST(MapErrors, ClosuresAreJudgedAlongTheAxesThatTheyBind) {
  const std::vector<Pose2> truth = square_track(0.0);
  Map track = track_along(truth);
  const Pose2 T_i_j = truth[2].inverse() * truth[80];
  const Pose2 off{T_i_j.x_m + 0.4, T_i_j.y_m, T_i_j.theta_rad};
  track.closures.push_back(closure_between(2, 80, T_i_j, ClosureAxes::kXY));
  track.closures.push_back(closure_between(2, 80, off, ClosureAxes::kXY));
  track.closures.push_back(closure_between(2, 80, off, ClosureAxes::kX));
  track.closures.push_back(closure_between(2, 80, off, ClosureAxes::kY));
  track.closures.back().closure.weight = 0.1;
  track.closures.push_back(track.closures[1]);
  track.closures.back().closure.weight = 0.1;
  track.closures.push_back(track.closures[1]);
  track.closures.back().closure.is_accepted = false;
  const ClosureCounts counts = map_errors(track, truth).closures;
  EXPECT_EQ(counts.num_accepted, 5U);
  EXPECT_EQ(counts.num_wrong, 3U);
  EXPECT_EQ(counts.num_wrong_heavy, 2U);
}

TEST(MapMedians, AreOfTheSeedsAndListTheWorst) {
  CircuitStudy study;
  study.runs.resize(3);
  study.runs[0].mapper_errors = {.first_mean_m = 0.03, .first_final_m = 0.1};
  study.runs[1].mapper_errors = {.first_mean_m = 0.01, .first_final_m = 0.5};
  study.runs[2].mapper_errors = {.first_mean_m = 0.09, .first_final_m = 0.2};
  const MapMedians medians = map_medians(study, &CircuitRun::mapper_errors);
  EXPECT_EQ(medians.final_m, 0.2);
  EXPECT_EQ(medians.worst_final_m, 0.5);
  EXPECT_EQ(medians.mean_m, 0.03);
  EXPECT_EQ(medians.worst_mean_m, 0.09);
}

/// The first 120 m of the large building.
TEST(CircuitStudy, TheFullMapperMapsTheLargeBuilding) {
  CircuitStudyParams params;
  params.num_seeds = 1;
  params.max_num_scans = 300;
  const CircuitStudy study = study_circuits(params, 1);
  const CircuitRun& run = study.runs.front();
  ASSERT_EQ(run.mapper.chain.T_map_base.size(), 300U);
  for (const MapErrors* errors : {&run.mapper_errors, &run.wheeled_errors}) {
    EXPECT_LT(errors->highest_m, 0.10);
    EXPECT_LT(errors->first_final_m, 0.25);
    EXPECT_LT(deg_from_rad(errors->heading_mean_rad), 0.1);
    EXPECT_EQ(errors->closures.num_wrong, 0U);
    EXPECT_EQ(errors->num_unjoined, 0U);
  }
  EXPECT_GT(study.mapper_map.size(), 1000U);
  EXPECT_NE(study.mapper_map, study.default_map);
}

TEST(ChainErrors, TheAxisOfAPlanIsThatOfItsWalls) {
  FloorPlan plan;
  const Pose2 turned{0.0, 0.0, 0.2};
  add_polyline(plan,
               {turned * Eigen::Vector2d(0, 0),
                turned * Eigen::Vector2d(30, 0),
                turned * Eigen::Vector2d(30, 10),
                turned * Eigen::Vector2d(0, 10)},
               Material::kWall);
  add_polyline(plan, {{0, 0}, {50, 50}}, Material::kClutter, false);
  EXPECT_NEAR(wrap_to_period(axis_of_plan(plan) - 0.2, 0.5 * kPi), 0.0, 1e-12);
}

}  // namespace setsquare::experiments::experiment_chain_test
