// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/closure_judgement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "tests/eval/random_trajectory.hpp"

namespace setsquare::closure_judgement_test {

using testing::random_pose;
using testing::stamp_at;

/// A closure between 1 s and 2 s.
LoopClosure closure_of(const Pose2& T_i_j, ClosureAxes axes = ClosureAxes::kXY) {
  return {stamp_at(1), stamp_at(2), T_i_j, axes, true, 1.0, "a test"};
}

/// Poses known exactly.
std::vector<ReferencePose> exact(const std::vector<Pose2>& poses) {
  std::vector<ReferencePose> expected;
  for (const Pose2& pose : poses) expected.push_back({pose});
  return expected;
}

ReferencePoses always(const std::vector<ReferencePose>& poses) {
  return [poses](Timestamp, Timestamp) { return poses; };
}

ClosureTruth verdict_of(const LoopClosure& closure,
                        const std::vector<Pose2>& expected,
                        const Trajectory& trajectory = {}) {
  return judge_closures({&closure, 1}, always(exact(expected)), PoseIndex(trajectory))
      .front()
      .verdict;
}

TEST(ClosureError, DistanceOfThePositionsAndWrappedRotation) {
  const auto error = closure_error(closure_of({1.3, 2.4, 3.1}), {1.0, 2.0, -3.1}, 0.7);
  EXPECT_NEAR(error.translation_m, 0.5, 1e-12);
  EXPECT_NEAR(error.rotation_rad, kTwoPi - 6.2, 1e-12);
}

// The robot looks along the map's y: what is ahead of it is off along y, what is aside along x.
TEST(ClosureError, OfASingleAxisIsThatAlongTheMapsAxis) {
  const Pose2 truth = {1.0, 2.0, 0.0};
  const Pose2 ahead = {3.0, 2.0, 0.0};
  const Pose2 aside = {1.0, 2.5, 0.0};
  EXPECT_NEAR(
      closure_error(closure_of(ahead, ClosureAxes::kX), truth, kPi / 2).translation_m, 0.0, 1e-12);
  EXPECT_NEAR(
      closure_error(closure_of(ahead, ClosureAxes::kY), truth, kPi / 2).translation_m, 2.0, 1e-12);
  EXPECT_NEAR(
      closure_error(closure_of(aside, ClosureAxes::kX), truth, kPi / 2).translation_m, 0.5, 1e-12);
  EXPECT_NEAR(
      closure_error(closure_of(aside, ClosureAxes::kY), truth, kPi / 2).translation_m, 0.0, 1e-12);
  EXPECT_NEAR(closure_error(closure_of(ahead, ClosureAxes::kX), truth, kPi / 4).translation_m,
              std::sqrt(2.0),
              1e-12);
}

TEST(ClosureTruth, RightUpToTheLimitsAndWrongBeyond) {
  const Pose2 truth = {1.0, 0.0, 0.0};
  EXPECT_EQ(verdict_of(closure_of({1.29, 0.0, 0.0}), {truth}), ClosureTruth::kRight);
  EXPECT_EQ(verdict_of(closure_of({1.0, -0.31, 0.0}), {truth}), ClosureTruth::kWrong);
  EXPECT_EQ(verdict_of(closure_of({1.0, 0.0, rad_from_deg(4.9)}), {truth}), ClosureTruth::kRight);
  EXPECT_EQ(verdict_of(closure_of({1.0, 0.0, rad_from_deg(-5.1)}), {truth}), ClosureTruth::kWrong);
}

TEST(ClosureTruth, WhereTheReferenceIsMissingOrDisputedThereIsNone) {
  const LoopClosure closure = closure_of({1.2, 0.0, 0.0});
  EXPECT_EQ(verdict_of(closure, {}), ClosureTruth::kUnjudged);
  EXPECT_EQ(verdict_of(closure, {{1.0, 0.0, 0.0}, {1.1, 0.0, 0.0}}), ClosureTruth::kRight);
  EXPECT_EQ(verdict_of(closure, {{1.0, 0.0, 0.0}, {0.8, 0.0, 0.0}}), ClosureTruth::kDisputed);
  EXPECT_EQ(verdict_of(closure, {{0.5, 0.0, 0.0}, {1.0, 0.0, 0.0}}), ClosureTruth::kDisputed);
  EXPECT_EQ(verdict_of(closure, {{0.5, 0.0, 0.0}, {0.8, 0.0, 0.0}}), ClosureTruth::kWrong);
}

// One sigma of 0.04 m and 0.5 deg: sure below 0.22 m and 4 deg, sure above 0.38 m or 6 deg.
TEST(ClosureTruth, NearTheLimitsTheNoiseOfTheReferenceDecidesNothing) {
  const auto verdict = [](const Pose2& T_i_j) {
    const ReferencePose zero = {{}, 0.04, rad_from_deg(0.5)};
    return judge_closure(closure_of(T_i_j), {&zero, 1}, std::nullopt).verdict;
  };
  EXPECT_EQ(verdict({0.21, 0, 0}), ClosureTruth::kRight);
  EXPECT_EQ(verdict({0.23, 0, 0}), ClosureTruth::kBorderline);
  EXPECT_EQ(verdict({0.37, 0, 0}), ClosureTruth::kBorderline);
  EXPECT_EQ(verdict({0.39, 0, 0}), ClosureTruth::kWrong);
  EXPECT_EQ(verdict({0.1, 0, rad_from_deg(3.9)}), ClosureTruth::kRight);
  EXPECT_EQ(verdict({0.1, 0, rad_from_deg(-4.1)}), ClosureTruth::kBorderline);
  EXPECT_EQ(verdict({0.1, 0, rad_from_deg(6.1)}), ClosureTruth::kWrong);
}

TEST(ClosureTruth, TheMoreCertainReferenceDecides) {
  const LoopClosure closure = closure_of({0.3, 0, 0});
  const ReferencePose unsure = {{}, 0.1, 0.0};
  const ReferencePose surely_right = {{0.2, 0, 0}, 0.05, 0.0};
  const ReferencePose surely_wrong = {{-0.2, 0, 0}, 0.05, 0.0};
  const auto verdict = [&closure](const std::vector<ReferencePose>& expected) {
    return judge_closure(closure, expected, std::nullopt).verdict;
  };
  EXPECT_EQ(verdict({unsure, unsure}), ClosureTruth::kBorderline);
  EXPECT_EQ(verdict({unsure, surely_right}), ClosureTruth::kRight);
  EXPECT_EQ(verdict({surely_wrong, unsure}), ClosureTruth::kWrong);
  EXPECT_EQ(verdict({surely_wrong, surely_right}), ClosureTruth::kDisputed);
}

// Metres off along a corridor that runs along the map's y are no error of a closure that binds x.
TEST(ClosureTruth, ASingleAxisNeedsTheHeadingInTheMap) {
  const Trajectory map = {{stamp_at(1), {9, 9, kPi / 2}}, {stamp_at(2), {9, 9, 0.3}}};
  const LoopClosure along = closure_of({4.0, 0.1, 0.0}, ClosureAxes::kX);
  EXPECT_EQ(verdict_of(along, {{1.0, 0.0, 0.0}}, map), ClosureTruth::kRight);
  EXPECT_EQ(verdict_of(along, {{1.0, 0.5, 0.0}}, map), ClosureTruth::kWrong);
  EXPECT_EQ(verdict_of(along, {{1.0, 0.0, 0.1}}, map), ClosureTruth::kWrong) << "turned";
  EXPECT_EQ(verdict_of(along, {{1.0, 0.0, 0.0}}), ClosureTruth::kUnjudged) << "no heading";
  EXPECT_EQ(verdict_of(closure_of({4.0, 0.1, 0.0}), {{1.0, 0.0, 0.0}}, map), ClosureTruth::kWrong);
}

TEST(ClosureTruth, AgainstATrueTrajectoryThePlantedWrongOneIsFound) {
  auto generator = testing::make_generator();
  const Trajectory truth = testing::random_trajectory(generator, 50);
  std::vector<LoopClosure> closures;
  for (std::size_t k = 0; k + 10 < truth.size(); ++k) {
    const Pose2 T_i_j = truth[k].pose.inverse() * truth[k + 10].pose;
    closures.push_back({truth[k].stamp,
                        truth[k + 10].stamp,
                        T_i_j * testing::small_motion(generator, 0.03, 0.01),
                        ClosureAxes::kXY,
                        true,
                        0.9,
                        ""});
  }
  closures[17].T_i_j.y_m += 0.6;
  closures[23].T_i_j.theta_rad += kPi;
  closures.push_back({stamp_at(3), stamp_at(1000), {}, ClosureAxes::kXY, true, 0.9, ""});
  const Trajectory elsewhere = testing::moved(truth, random_pose(generator));
  const auto judgements =
      judge_closures(closures, expected_from_trajectory(elsewhere, 0.02), PoseIndex({}));
  for (std::size_t k = 0; k < closures.size(); ++k) {
    const ClosureTruth expected = k == 17 || k == 23 ? ClosureTruth::kWrong
                                  : k == 40          ? ClosureTruth::kUnjudged
                                                     : ClosureTruth::kRight;
    EXPECT_EQ(judgements[k].verdict, expected) << k;
  }
}

TEST(ClosureSummary, CountsAcceptedAndRefusedApart) {
  using enum ClosureTruth;
  const auto judged = [](bool is_accepted, double weight) {
    return LoopClosure{stamp_at(1), stamp_at(2), {}, ClosureAxes::kXY, is_accepted, weight, ""};
  };
  const std::vector<LoopClosure> closures = {judged(true, 0.9),
                                             judged(true, 0.3),
                                             judged(true, 0.31),
                                             judged(true, 1.0),
                                             judged(true, 1.0),
                                             judged(false, 0.9),
                                             judged(false, 0.0)};
  const std::vector<ClosureJudgement> judgements = {{kRight, {}},
                                                    {kWrong, {}},
                                                    {kWrong, {}},
                                                    {kDisputed, {}},
                                                    {},
                                                    {kWrong, {}},
                                                    {kBorderline, {}}};
  const ClosureSummary summary = summarise_closures(closures, judgements);
  EXPECT_EQ(summary.accepted.num_closures, 5U);
  EXPECT_EQ(summary.accepted.num_judged(), 3U);
  EXPECT_EQ(summary.accepted.num_wrong, 2U);
  EXPECT_EQ(summary.accepted.num_disputed, 1U);
  EXPECT_EQ(summary.accepted.num_unjudged, 1U);
  EXPECT_EQ(summary.refused.num_closures, 2U);
  EXPECT_EQ(summary.refused.num_wrong, 1U);
  EXPECT_EQ(summary.refused.num_borderline, 1U);
  EXPECT_EQ(summary.refused.num_judged(), 1U);
  EXPECT_EQ(summary.num_heavy_wrong, 1U) << "0.3 itself is not above 0.3, refused ones do not pull";
}

}  // namespace setsquare::closure_judgement_test
