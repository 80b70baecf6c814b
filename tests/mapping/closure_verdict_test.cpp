// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <set>

#include "setsquare/core/error.hpp"
#include "setsquare/mapping/loops/verdict.hpp"

namespace setsquare::closure_verdict_test {

const ClosureVerdictParams kParams;

/// `strong_points` bind the direction at `strong_rad`, `open_points` the one across it.
void bind(SubmapMatch& match, double strong_rad, double strong_points, double open_points) {
  const Eigen::Vector2d strong(std::cos(strong_rad), std::sin(strong_rad));
  const Eigen::Vector2d open(-strong.y(), strong.x());
  match.best.hessian.setZero();
  match.best.hessian.topLeftCorner<2, 2>() =
      strong_points * strong * strong.transpose() + open_points * open * open.transpose();
  match.best.hessian(2, 2) = 500.0;
  match.open = open_direction(match.best.hessian.topLeftCorner<2, 2>());
}

/// Bound along both axes, without a rival.
SubmapMatch good_match() {
  SubmapMatch match;
  match.best.T_reference_current = {1.0, 2.0, 0.3};
  match.best.score = 0.8;
  match.best.agreement = 0.95;
  match.best.contradiction = 0.02;
  bind(match, 0.0, 200.0, 100.0);
  return match;
}

/// A corridor along `along_rad` in the reference's frame.
SubmapMatch corridor_match(double along_rad) {
  SubmapMatch match = good_match();
  bind(match, along_rad + 0.5 * kPi, 200.0, 2.0);
  return match;
}

SubmapFitBothWays rival_at(const SubmapMatch& match, double angle_rad, double score) {
  SubmapFitBothWays rival = match.best;
  rival.T_reference_current.x_m += std::cos(angle_rad);
  rival.T_reference_current.y_m += std::sin(angle_rad);
  rival.score = score;
  return rival;
}

ClosureReason reason_of(const SubmapMatch& match, double heading_rad = 0.0) {
  return closure_verdict(match, heading_rad, kParams).reason;
}

TEST(ClosureVerdict, AGoodMatchStandsAlone) {
  const ClosureVerdict verdict = closure_verdict(good_match(), 0.7);
  EXPECT_EQ(verdict.reason, ClosureReason::kStandsAlone);
  EXPECT_EQ(verdict.axes, ClosureAxes::kXY);
}

TEST(ClosureVerdict, ALowScoreIsRefused) {
  SubmapMatch match = good_match();
  match.best.score = kParams.min_score - 1e-6;
  EXPECT_EQ(reason_of(match), ClosureReason::kLowScore);
  match.best.score = kParams.min_score;
  EXPECT_EQ(reason_of(match), ClosureReason::kStandsAlone);
}

TEST(ClosureVerdict, AContradictedOneIsRefused) {
  SubmapMatch match = good_match();
  match.best.contradiction = kParams.max_contradiction + 1e-6;
  EXPECT_EQ(reason_of(match), ClosureReason::kContradicted);
}

TEST(ClosureVerdict, ARunnerUpWithinTheMarginMakesItAmbiguous) {
  SubmapMatch match = good_match();
  match.others = {rival_at(match, 0.4, match.best.score - kParams.min_margin + 1e-6)};
  match.others[0].agreement = 0.0;
  EXPECT_EQ(reason_of(match), ClosureReason::kAmbiguous);
  match.others[0].score = match.best.score - kParams.min_margin - 1e-6;
  EXPECT_EQ(reason_of(match), ClosureReason::kStandsAlone);
}

TEST(ClosureVerdict, ARivalThatAgreesAsWellMakesItAmbiguous) {
  // However much more of it is hidden, so that its score is low.
  SubmapMatch match = good_match();
  match.others = {rival_at(match, 0.4, 0.3)};
  match.others[0].agreement = match.best.agreement - kParams.min_margin + 1e-6;
  EXPECT_EQ(reason_of(match), ClosureReason::kAmbiguous);
  match.others[0].agreement = match.best.agreement - kParams.min_margin - 1e-6;
  EXPECT_EQ(reason_of(match), ClosureReason::kStandsAlone);
}

TEST(ClosureVerdict, ACorridorBindsOneAxis) {
  // Whatever the reference's heading, the axis that the map leaves open decides.
  for (const double heading_rad : {0.0, 0.9, -2.0}) {
    const ClosureVerdict along_x =
        closure_verdict(corridor_match(-heading_rad), heading_rad, kParams);
    EXPECT_EQ(along_x.reason, ClosureReason::kOneAxis);
    EXPECT_EQ(along_x.axes, ClosureAxes::kY);
    const ClosureVerdict along_y =
        closure_verdict(corridor_match(0.5 * kPi - heading_rad), heading_rad, kParams);
    EXPECT_EQ(along_y.reason, ClosureReason::kOneAxis);
    EXPECT_EQ(along_y.axes, ClosureAxes::kX);
  }
}

TEST(ClosureVerdict, AnOpenDirectionAskewIsRefused) {
  const double limit_rad = kParams.max_askew_rad;
  EXPECT_EQ(reason_of(corridor_match(limit_rad - 0.01)), ClosureReason::kOneAxis);
  EXPECT_EQ(reason_of(corridor_match(limit_rad + 0.01)), ClosureReason::kOpenDirection);
  EXPECT_EQ(reason_of(corridor_match(-limit_rad - 0.01)), ClosureReason::kOpenDirection);
}

TEST(ClosureVerdict, InACorridorRivalsAlongItDoNoHarm) {
  SubmapMatch match = corridor_match(0.0);
  match.others = {rival_at(match, 0.0, match.best.score), rival_at(match, kPi, match.best.score)};
  EXPECT_EQ(reason_of(match), ClosureReason::kOneAxis);
  match.others.push_back(rival_at(match, kParams.max_rival_rad + 0.01, match.best.score));
  EXPECT_EQ(reason_of(match), ClosureReason::kAmbiguous) << "the third one lies across";
}

TEST(ClosureVerdict, InACorridorARivalAcrossItDoesHarm) {
  SubmapMatch match = corridor_match(0.0);
  match.others = {rival_at(match, 0.0, 0.3)};
  EXPECT_EQ(reason_of(match), ClosureReason::kOneAxis);
  match.others = {rival_at(match, 1.0, 0.3)};
  EXPECT_EQ(reason_of(match), ClosureReason::kAmbiguous);
  match.others[0].agreement = 0.5;
  EXPECT_EQ(reason_of(match), ClosureReason::kOneAxis);
}

TEST(ClosureVerdict, FewPointsAllAroundAreNoCorridor) {
  SubmapMatch match = good_match();
  bind(match, 0.0, 9.0, 8.0);
  EXPECT_EQ(reason_of(match), ClosureReason::kOpenDirection);
}

TEST(ClosureVerdict, EveryReasonHasItsOwnWords) {
  std::set<std::string_view> words;
  for (const ClosureReason reason : {ClosureReason::kStandsAlone,
                                     ClosureReason::kOneAxis,
                                     ClosureReason::kNoPose,
                                     ClosureReason::kLowScore,
                                     ClosureReason::kContradicted,
                                     ClosureReason::kAmbiguous,
                                     ClosureReason::kOpenDirection}) {
    words.insert(to_string(reason));
    EXPECT_EQ(to_string(reason).find('\t'), std::string_view::npos);
  }
  EXPECT_EQ(words.size(), 7U);
}

TEST(ClosureVerdict, RefusesParametersThatAreNone) {
  EXPECT_THROW(ClosureVerdictParams{.min_score = 0.0}.validate(), ParameterError);
  EXPECT_THROW(ClosureVerdictParams{.max_contradiction = -0.1}.validate(), ParameterError);
  EXPECT_THROW(ClosureVerdictParams{.min_effective_points = 0.0}.validate(), ParameterError);
}

TEST(ComparedPlaces, HaveNoInformationAlongAnOpenDirection) {
  constexpr double kHeading_rad = 0.4;
  SubmapMatch match = corridor_match(-kHeading_rad);
  const Eigen::Vector3d open(std::cos(-kHeading_rad), std::sin(-kHeading_rad), 0.0);
  const Eigen::Vector3d bound(-open.y(), open.x(), 0.0);
  // The rotation is coupled with either direction.
  Eigen::Matrix3d& hessian = match.best.hessian;
  hessian.topRightCorner<2, 1>() = (7.0 * open + 40.0 * bound).head<2>();
  hessian.bottomLeftCorner<1, 2>() = hessian.topRightCorner<2, 1>().transpose();
  const ComparedPlaces places = judged_places(3, 9, match, kHeading_rad, 0.1, kParams);
  ASSERT_EQ(places.verdict.reason, ClosureReason::kOneAxis);
  // What stays when nothing is known along `open`: 2 points bind it, b is coupled with it.
  const Eigen::Vector3d b = hessian * open;
  const Eigen::Matrix3d expected = (hessian - b * b.transpose() / 2.0) / 0.01;
  EXPECT_TRUE(places.information.isApprox(expected, 1e-12));
  EXPECT_LT((places.information * open).norm(), 1e-9 * places.information.norm());
  EXPECT_NEAR(bound.dot(places.information * bound), 200.0 / 0.01, 1e-6);
  EXPECT_NEAR(places.information(2, 2), (500.0 - 7.0 * 7.0 / 2.0) / 0.01, 1e-6);
}

TEST(ComparedPlaces, BecomeAConstraint) {
  const SubmapMatch match = good_match();
  const ComparedPlaces places = judged_places(3, 9, match, 0.0, 0.1, kParams);
  EXPECT_TRUE(places.information.isApprox(match.best.hessian / 0.01, 1e-12));
  EXPECT_EQ(places.score, match.best.score);
  EXPECT_EQ(places.contradiction, match.best.contradiction);
  const Constraint constraint = closure_constraint(places);
  EXPECT_EQ(constraint.from, 3U);
  EXPECT_EQ(constraint.to, 9U);
  EXPECT_EQ(constraint.T_from_to, match.best.T_reference_current);
  EXPECT_EQ(constraint.information, places.information);
  EXPECT_EQ(constraint.kind, ConstraintKind::kLoopClosure);
  EXPECT_EQ(constraint.weight, 1.0);
}

}  // namespace setsquare::closure_verdict_test
