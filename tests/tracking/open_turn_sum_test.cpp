// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// How far off a turn may be that the walls leave open. Kind of place: round halls.
#include <gtest/gtest.h>

#include <cmath>

#include "setsquare/core/error.hpp"
#include "setsquare/tracking/motion_uncertainty.hpp"

namespace setsquare::open_turn_sum_test {

const MotionUncertaintyParams kParams;

TrackedPose bound_at(const Pose2& T_odom_body) {
  TrackedPose tracked;
  tracked.T_odom_body = T_odom_body;
  return tracked;
}

SweepStart after(double seconds) { return {0, timestamp_from_seconds(seconds)}; }

/// A scan in a round hall, `to_middle_m` from its middle: all walls face that.
TrackedPose open_turn_at(const Pose2& T_odom_body, double to_middle_m = 3.0) {
  TrackedPose tracked = bound_at(T_odom_body);
  tracked.status = TrackStatus::kDegenerate;
  tracked.turn_bound_share = 0.0;
  tracked.turn_motion_m = {0.6 * to_middle_m, -0.8 * to_middle_m};
  return tracked;
}

/// The sum of a run of open turns behind one scan that is bound: `num` scans, 0.1 s apart, the
/// robot turning and driving by the same from each to the next.
double open_turn_sum_rad(int num,
                         bool has_odometry,
                         const Pose2& step = {},
                         const MotionUncertaintyParams& params = kParams) {
  MotionUncertainty uncertainty(params);
  double sum_rad = 0.0;
  Pose2 pose;
  for (int i = 0; i <= num; ++i) {
    TrackedPose scan = i == 0 ? bound_at(pose) : open_turn_at(pose);
    scan.has_odometry = has_odometry;
    uncertainty.add(scan, after(0.1 * i));
    sum_rad += uncertainty.open_turn_sigma_rad();
    pose = pose * step;
  }
  return sum_rad;
}

// The walls of a round hall tell no turn: the estimate's own turn tells nothing either.
TEST(OpenTurnSum, WithoutOdometryItGrowsWithTheTime) {
  for (const int num : {1, 2, 5}) {  // While it may turn faster and faster.
    const double seconds = 0.1 * num;
    EXPECT_NEAR(open_turn_sum_rad(num, false),
                0.5 * kParams.open_turn_rad_per_s2 * seconds * (seconds + 0.1),
                1e-9);
  }
  EXPECT_NEAR(open_turn_sum_rad(25, false) - open_turn_sum_rad(15, false),
              kParams.open_turn_rad_per_s,
              1e-9);
  EXPECT_EQ(open_turn_sum_rad(15, false, {0.1, 0.0, 0.2}), open_turn_sum_rad(15, false));
}

TEST(OpenTurnSum, WithoutOdometryItEndsWhereAnyHeadingIsAsLikely) {
  const double most_rad = open_turn_sum_rad(100, false);
  EXPECT_NEAR(open_turn_sum_rad(600, false), most_rad, 1e-9);
  // More than of a heading of which nothing is known, and no more than that by much.
  EXPECT_GT(most_rad, kPi / std::sqrt(3.0));
  EXPECT_LT(most_rad, kPi);
  EXPECT_LT(open_turn_sum_rad(20, false), most_rad) << "the bound is not met at once";
}

TEST(OpenTurnSum, WithOdometryItGrowsWithTheTurnAndTheWay) {
  const double share = kParams.open_sigma_per_turn_by_odometry;
  for (const double turn_rad : {0.05, -0.05, 0.2}) {
    EXPECT_NEAR(
        open_turn_sum_rad(10, true, {0.0, 0.0, turn_rad}), 10.0 * share * std::abs(turn_rad), 1e-9);
  }
  EXPECT_NEAR(open_turn_sum_rad(10, true, {0.3, 0.4, 0.0}),
              10.0 * 0.5 * kParams.open_turn_rad_per_metre_by_odometry,
              1e-9);
  EXPECT_EQ(open_turn_sum_rad(300, true), 0.0) << "a robot that stands, by its odometry";
  EXPECT_GT(open_turn_sum_rad(300, false), 1.0) << "without odometry nobody knows";
}

TEST(OpenTurnSum, SigmasOfARunAddUp) {
  // The same turn in one step or in eight. Variances would say a third.
  const double in_one_rad = open_turn_sum_rad(1, true, {0.0, 0.0, 0.8});
  const double in_eight_rad = open_turn_sum_rad(8, true, {0.0, 0.0, 0.1});
  EXPECT_NEAR(in_eight_rad, in_one_rad, 1e-9);
}

TEST(OpenTurnSum, OdometryThatProvedWorseCountsAsItProved) {
  const auto step_rad = [](double deviation) {
    MotionUncertainty uncertainty(kParams);
    uncertainty.add(bound_at({}), after(0.0));
    TrackedPose scan = open_turn_at({0.0, 0.0, 0.5});
    scan.has_odometry = true;
    scan.odometry_turn_deviation = deviation;
    uncertainty.add(scan, after(0.1));
    return uncertainty.open_turn_sigma_rad();
  };
  EXPECT_NEAR(step_rad(0.2), 0.1, 1e-12);
  EXPECT_EQ(step_rad(0.001), step_rad(0.0)) << "one that proved better by chance";
}

TEST(OpenTurnSum, TheSensorMovesByTheTurnAndTheDistanceToTheMiddle) {
  for (const double to_middle_m : {0.0, 1.0, 4.0}) {
    MotionUncertainty uncertainty(kParams);
    EXPECT_EQ(uncertainty.add(open_turn_at({}, to_middle_m), after(0.0)), 0.0) << "no motion yet";
    const double moved_m = uncertainty.add(open_turn_at({}, to_middle_m), after(0.1));
    EXPECT_GT(uncertainty.open_turn_sigma_rad(), 0.0);
    EXPECT_NEAR(moved_m, to_middle_m * uncertainty.open_turn_sigma_rad(), 1e-12);
  }
}

/// What the next scan with an open turn adds behind a long run and one scan more.
double next_step_rad(const TrackedPose& last) {
  MotionUncertainty uncertainty(kParams);
  uncertainty.add(bound_at({}), after(0.0));
  for (int i = 1; i <= 100; ++i) uncertainty.add(open_turn_at({}), after(0.1 * i));
  uncertainty.add(last, after(10.1));
  uncertainty.add(open_turn_at({}), after(10.2));
  return uncertainty.open_turn_sigma_rad();
}

// Behind a long run any heading is as likely: nothing is added until a scan ends the run.
TEST(OpenTurnSum, AScanThatDeterminesThePoseEndsTheRun) {
  EXPECT_NEAR(next_step_rad(bound_at({})), 0.1 * 0.1 * kParams.open_turn_rad_per_s2, 1e-9);
  TrackedPose corridor = bound_at({});
  corridor.status = TrackStatus::kDegenerate;  // Open along a direction, its turn is bound.
  EXPECT_EQ(next_step_rad(corridor), next_step_rad(bound_at({})));
}

TEST(OpenTurnSum, AScanThatIsLostOrOpenItselfDoesNot) {
  TrackedPose lost = bound_at({});
  lost.status = TrackStatus::kLost;
  EXPECT_NEAR(next_step_rad(lost), 0.0, 1e-12);
  EXPECT_NEAR(next_step_rad(open_turn_at({})), 0.0, 1e-12);
  TrackedPose half_bound = open_turn_at({});
  half_bound.turn_bound_share = 0.9;
  EXPECT_NEAR(next_step_rad(half_bound), 0.0, 1e-12);
}

TEST(OpenTurnSum, TheMoreTheWallsBindATurnTheLessItAdds) {
  double last_rad = open_turn_sum_rad(10, false);
  for (const double share : {0.2, 0.5, 0.9, 1.0}) {
    MotionUncertainty uncertainty(kParams);
    double sum_rad = 0.0;
    for (int i = 0; i <= 10; ++i) {
      TrackedPose scan = open_turn_at({});
      if (i > 0) scan.turn_bound_share = share;
      uncertainty.add(scan, after(0.1 * i));
      sum_rad += uncertainty.open_turn_sigma_rad();
    }
    EXPECT_LT(sum_rad, last_rad) << share;
    last_rad = sum_rad;
  }
  EXPECT_EQ(last_rad, 0.0);
}

/// The rule switched off: robots that cannot turn, odometry that is never off.
TEST(OpenTurnSum, IsZeroWithoutTheRule) {
  MotionUncertaintyParams params;
  params.open_turn_rad_per_s2 = 0.0;
  params.open_sigma_per_turn_by_odometry = 0.0;
  params.open_turn_rad_per_metre_by_odometry = 0.0;
  EXPECT_EQ(open_turn_sum_rad(50, false, {}, params), 0.0);
  EXPECT_EQ(open_turn_sum_rad(50, true, {0.1, 0.0, 0.1}, params), 0.0);
  EXPECT_GT(open_turn_sum_rad(50, true, {0.1, 0.0, 0.1}), 0.1);
}

TEST(OpenTurnSum, RefusesWhatIsNoSigma) {
  EXPECT_THROW(MotionUncertaintyParams{.open_turn_rad_per_s2 = -1.0}.validate(), ParameterError);
  EXPECT_THROW(MotionUncertaintyParams{.open_turn_rad_per_s = -1.0}.validate(), ParameterError);
  EXPECT_THROW(MotionUncertaintyParams{.open_sigma_per_turn_by_odometry = -1.0}.validate(),
               ParameterError);
  EXPECT_THROW(MotionUncertaintyParams{.open_turn_rad_per_metre_by_odometry = -1.0}.validate(),
               ParameterError);
}

}  // namespace setsquare::open_turn_sum_test
