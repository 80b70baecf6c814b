// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/loops/submap_matcher.hpp"

#include <gtest/gtest.h>

#include "setsquare/core/error.hpp"
#include "setsquare/mapping/loops/verdict.hpp"
#include "tests/mapping/tracked_world.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::submap_matcher_test {

using testing::between;
using testing::PoseNear;
using testing::PoseTolerance;
using testing::uniform;

constexpr double kNoise_m = 0.01;

/// A world, keyframes in it, and submaps about some of them.
struct SurveyedWorld {
  SurveyedWorld(const std::vector<testing::Wall>& walls,
                const std::vector<Eigen::Vector2d>& waypoints_m)
      : poses(testing::spaced(testing::drive(waypoints_m))),
        track(testing::track_in_world(walls, poses, kNoise_m)) {}

  [[nodiscard]] Submap about(std::size_t keyframe) const {
    return make_submap(track, poses, keyframe, 3);
  }

  std::vector<Pose2> poses;
  KeyframeTrack track;
};

SurveyedWorld room() { return {testing::l_shaped_room(), testing::way_around_the_room()}; }

TEST(SubmapMatcher, FindsTheOffsetFromAnywhereInTheWindow) {
  std::mt19937_64 generator = testing::make_generator();
  const SurveyedWorld world = room();
  const std::size_t n = world.poses.size();
  const double window_m = 1.5;
  for (int num_tried = 0; num_tried < 20;) {
    const auto from = static_cast<std::size_t>(generator() % n);
    const auto to = static_cast<std::size_t>(generator() % n);
    const Pose2 truth = between(world.poses[from], world.poses[to]);
    if (to < from + 10 || truth.translation().norm() > 3.0) continue;
    const Pose2 off{uniform(generator, -window_m, window_m),
                    uniform(generator, -window_m, window_m),
                    rad_from_deg(uniform(generator, -0.2, 0.2))};
    const ExpectedPose expected{
        {truth.x_m + off.x_m, truth.y_m + off.y_m, truth.theta_rad + off.theta_rad}, window_m};
    const auto match = match_submaps(world.about(from), world.about(to), expected);
    ASSERT_TRUE(match.has_value());
    EXPECT_THAT(
        match->best.T_reference_current,
        PoseNear(truth, PoseTolerance{.translation_m = 0.006, .rotation_rad = rad_from_deg(0.15)}))
        << from << " to " << to;
    EXPECT_GT(match->best.score, 0.6);
    EXPECT_LT(match->best.contradiction, 0.05);
    ++num_tried;
  }
}

TEST(SubmapMatcher, IsTheSameTheOtherWayRound) {
  const SurveyedWorld world = room();
  const Submap a = world.about(10);
  const Submap b = world.about(30);
  const Pose2 truth = between(world.poses[10], world.poses[30]);
  const auto forward = match_submaps(a, b, {truth, 0.5});
  const auto backward = match_submaps(b, a, {truth.inverse(), 0.5});
  ASSERT_TRUE(forward && backward);
  EXPECT_THAT(backward->best.T_reference_current,
              PoseNear(forward->best.T_reference_current.inverse(),
                       PoseTolerance{.translation_m = 1e-3, .rotation_rad = rad_from_deg(0.02)}));
  EXPECT_NEAR(backward->best.score, forward->best.score, 0.02);
  EXPECT_NEAR(backward->open.effective_points, forward->open.effective_points, 1.0);
}

TEST(SubmapMatcher, TheWayBackCountsByTheDerivativeOfTheInverse) {
  const SurveyedWorld world = room();
  const Submap reference = world.about(10);
  const Submap current = world.about(30);
  const SubmapMatchParams params;
  const auto match =
      match_submaps(reference, current, {between(world.poses[10], world.poses[30]), 0.5});
  ASSERT_TRUE(match.has_value());
  const Pose2 T = match->best.T_reference_current;
  PointMarks marks;
  const SubmapAlignment forward =
      align_with_submap(reference.images, current.fine, T, params.settling, marks);
  const SubmapAlignment backward =
      align_with_submap(current.images, reference.fine, T.inverse(), params.settling, marks);
  Eigen::Matrix3d J;
  for (int axis = 0; axis < 3; ++axis) {
    constexpr double kStep = 1e-6;
    const auto moved = [&](double step) {
      Pose2 pose = T;
      (axis == 0 ? pose.x_m : axis == 1 ? pose.y_m : pose.theta_rad) += step;
      const Pose2 inverse = pose.inverse();
      return Eigen::Vector3d(inverse.x_m, inverse.y_m, inverse.theta_rad);
    };
    J.col(axis) = (moved(kStep) - moved(-kStep)) / (2.0 * kStep);
  }
  const Eigen::Matrix3d hessian = forward.hessian + J.transpose() * backward.hessian * J;
  const Eigen::Vector3d gradient = forward.gradient + J.transpose() * backward.gradient;
  EXPECT_TRUE(match->best.hessian.isApprox(hessian, 1e-6));
  EXPECT_TRUE(match->best.gradient.isApprox(gradient, 1e-4));
}

TEST(SubmapMatcher, ReturnsNothingOutsideTheWindowAndItsMargin) {
  std::mt19937_64 generator = testing::make_generator();
  const SurveyedWorld world = room();
  const double window_m = 0.4;
  for (int trial = 0; trial < 12; ++trial) {
    const Pose2 truth = between(world.poses[10], world.poses[30]);
    const double angle_rad = uniform(generator, -kPi, kPi);
    const Pose2 wrong{truth.x_m + 2.0 * std::cos(angle_rad),
                      truth.y_m + 2.0 * std::sin(angle_rad),
                      truth.theta_rad};
    const auto match = match_submaps(world.about(10), world.about(30), {wrong, window_m});
    if (!match) continue;
    const Eigen::Vector2d off_m =
        match->best.T_reference_current.translation() - wrong.translation();
    EXPECT_LE(off_m.cwiseAbs().maxCoeff(), window_m + 0.25 + 1e-9);
    EXPECT_FALSE(is_accepted(closure_verdict(*match, world.poses[10].theta_rad).reason));
  }
}

TEST(SubmapMatcher, ABareCorridorIsOpenAlongItself) {
  const SurveyedWorld world(testing::bare_corridor(), {{-6.0, 0.2}, {6.0, -0.1}});
  const Pose2 truth = between(world.poses[8], world.poses[20]);
  const auto match = match_submaps(world.about(8), world.about(20), {truth, 1.0});
  ASSERT_TRUE(match.has_value());
  const double along_rad =
      std::atan2(match->open.direction.y(), match->open.direction.x()) + world.poses[8].theta_rad;
  EXPECT_LT(std::abs(wrap_to_period(along_rad, kPi)), rad_from_deg(2.0));
  EXPECT_LT(match->open.effective_points, 3.0);
  // Across the corridor it is right.
  const Eigen::Vector2d off_m =
      Pose2{0.0, 0.0, world.poses[8].theta_rad} *
      (match->best.T_reference_current.translation() - truth.translation()).eval();
  EXPECT_LT(std::abs(off_m.y()), 0.01);
  const ClosureVerdict verdict = closure_verdict(*match, world.poses[8].theta_rad);
  EXPECT_EQ(verdict.reason, ClosureReason::kOneAxis);
  EXPECT_EQ(verdict.axes, ClosureAxes::kY);
}

/// A corridor with a niche every 2 m on either side: moved by 2 m it is the same.
std::vector<testing::Wall> corridor_of_niches() {
  std::vector<testing::Wall> walls;
  for (int k = -20; k < 20; ++k) {
    const double x_m = 2.0 * k;
    for (const double side : {-1.0, 1.0}) {
      walls.push_back({x_m, side, x_m + 1.3, side});
      walls.push_back({x_m + 1.3, side, x_m + 1.3, 1.3 * side});
      walls.push_back({x_m + 1.3, 1.3 * side, x_m + 2.0, 1.3 * side});
      walls.push_back({x_m + 2.0, 1.3 * side, x_m + 2.0, side});
    }
  }
  return walls;
}

TEST(SubmapMatcher, WhereAllNichesAreAlikeNothingStandsAlone) {
  // Where two views stand farther apart more of each is hidden from the other: the score is lower,
  // as right as the place may be. The agreement is not.
  std::mt19937_64 generator = testing::make_generator();
  const SurveyedWorld world(corridor_of_niches(), {{-8.0, 0.1}, {8.0, -0.1}, {-8.0, 0.2}});
  const std::size_t half = world.poses.size() / 2;
  for (int num_tried = 0; num_tried < 40;) {
    const std::size_t from = 4 + generator() % (half - 8);
    const std::size_t to = half + 4 + generator() % (half - 8);
    Pose2 expected = between(world.poses[from], world.poses[to]);
    if (expected.translation().norm() > 4.0) continue;
    ++num_tried;
    expected.x_m += uniform(generator, -1.5, 1.5);
    const auto match = match_submaps(world.about(from), world.about(to), {expected, 2.5});
    ASSERT_TRUE(match && !match->others.empty());
    double rival_agreement = -1.0;
    for (const SubmapFitBothWays& other : match->others) {
      rival_agreement = std::max(rival_agreement, other.agreement);
    }
    EXPECT_LT(match->best.agreement - rival_agreement, ClosureVerdictParams{}.min_margin);
    EXPECT_NE(closure_verdict(*match, world.poses[from].theta_rad).reason,
              ClosureReason::kStandsAlone)
        << from << " to " << to;
  }
}

/// A wide hall: 24 m by 8 m, with pillars that differ from place to place.
std::vector<testing::Wall> hall_of_pillars() {
  std::vector<testing::Wall> walls = testing::empty_rectangle(24.0, 8.0);
  for (const auto& [x_m, y_m] : {std::pair{3.0, 2.0}, {7.5, 5.5}, {12.0, 1.5}, {16.0, 6.0}}) {
    walls.push_back({x_m, y_m, x_m + 0.8, y_m});
    walls.push_back({x_m + 0.8, y_m, x_m + 0.8, y_m + 0.5});
    walls.push_back({x_m + 0.8, y_m + 0.5, x_m, y_m + 0.5});
    walls.push_back({x_m, y_m + 0.5, x_m, y_m});
  }
  return walls;
}

TEST(SubmapMatcher, LooksAllOverTheWindowHoweverFarItsMiddle) {
  const SurveyedWorld world(hall_of_pillars(), {{2.0, 4.0}, {21.0, 4.2}});
  const std::size_t from = 4;
  std::size_t to = from;
  while (between(world.poses[from], world.poses[to]).translation().norm() < 8.5) ++to;
  const Pose2 truth = between(world.poses[from], world.poses[to]);
  for (const double off_m : {-5.0, -3.0, 3.0, 5.0}) {
    Pose2 expected = truth;
    expected.x_m += off_m;
    const auto match = match_submaps(world.about(from), world.about(to), {expected, 6.0});
    ASSERT_TRUE(match) << off_m;
    EXPECT_LT((match->best.T_reference_current.translation() - truth.translation()).norm(), 0.03)
        << off_m;
  }
}

TEST(SubmapMatcher, RefusesParametersThatAreNone) {
  EXPECT_THROW(SubmapMatchParams{.max_num_proposals = 0}.validate(), ParameterError);
  EXPECT_THROW(SubmapMatchParams{.heading_weight = -1.0}.validate(), ParameterError);
  EXPECT_THROW(SubmapMatchParams{.min_compared = 0.0}.validate(), ParameterError);
  EXPECT_THROW(SubmapMatchParams{.distinct_m = 0.0}.validate(), ParameterError);
}

}  // namespace setsquare::submap_matcher_test
