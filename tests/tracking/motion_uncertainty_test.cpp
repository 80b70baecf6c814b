// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/motion_uncertainty.hpp"

#include <gtest/gtest.h>

#include "setsquare/core/error.hpp"

namespace setsquare::motion_uncertainty_test {

const MotionUncertaintyParams kParams;

TrackedPose at(const Pose2& T_odom_body, TrackStatus status = TrackStatus::kTracked) {
  TrackedPose tracked;
  tracked.status = status;
  tracked.T_odom_body = T_odom_body;
  return tracked;
}

TrackedPose open_along(double direction_rad, const Pose2& T_odom_sensor) {
  TrackedPose tracked = at(T_odom_sensor, TrackStatus::kDegenerate);
  tracked.open_bound_share = 0.0;
  tracked.open.direction = {std::cos(direction_rad), std::sin(direction_rad)};
  return tracked;
}

SweepStart after(double seconds) { return {0, timestamp_from_seconds(seconds)}; }

/// Scans 0.1 s apart.
MotionCovariance covariance_of(const std::vector<TrackedPose>& scans, bool has_odometry = false) {
  MotionUncertainty uncertainty(kParams);
  double stamp_s = 0.0;
  for (TrackedPose scan : scans) {
    scan.has_odometry = has_odometry;
    uncertainty.add(scan, after(stamp_s));
    stamp_s += 0.1;
  }
  return uncertainty.take();
}

double square(double value) { return value * value; }

TEST(MotionUncertainty, AStepHasItsShareOfLengthAndTurn) {
  const MotionCovariance covariance = covariance_of({at({}), at({0.3, 0.4, -0.2})});
  const double sigma_m = kParams.step_sigma_m + kParams.sigma_per_metre * 0.5;
  EXPECT_TRUE(
      covariance.translation_m2.isApprox(square(sigma_m) * Eigen::Matrix2d::Identity(), 1e-12));
  EXPECT_NEAR(covariance.rotation_rad2,
              square(kParams.step_sigma_rad + kParams.sigma_per_turn * 0.2),
              1e-15);
}

TEST(MotionUncertainty, KeyframesOfTwoScannersShareTheNoiseOfAStep) {
  const auto taken = [](double share_of_step, TrackStatus status) {
    MotionUncertainty uncertainty(kParams);
    uncertainty.add(at({}), after(0.0));
    uncertainty.add(at({}, status), after(0.1));
    return uncertainty.take(share_of_step);
  };
  const MotionCovariance whole = taken(1.0, TrackStatus::kTracked);
  const MotionCovariance half = taken(0.5, TrackStatus::kTracked);
  EXPECT_TRUE(half.translation_m2.isApprox(0.5 * whole.translation_m2, 1e-12));
  EXPECT_NEAR(half.rotation_rad2, 0.5 * whole.rotation_rad2, 1e-15);
  // What a lost scan leaves open is not shared: nobody saw it.
  EXPECT_NEAR(taken(0.5, TrackStatus::kLost).rotation_rad2 - half.rotation_rad2,
              square(kParams.lost_sigma_rad),
              1e-12);
}

TEST(MotionUncertainty, VariancesOfLostScansAddUp) {
  const MotionCovariance none = covariance_of({at({})});
  for (int num_lost = 1; num_lost <= 5; ++num_lost) {
    const std::vector<TrackedPose> scans(static_cast<std::size_t>(num_lost),
                                         at({}, TrackStatus::kLost));
    const MotionCovariance lost = covariance_of(scans);
    const Eigen::Matrix2d added_m2 = lost.translation_m2 - none.translation_m2;
    EXPECT_TRUE(added_m2.isApprox(
        num_lost * square(kParams.lost_sigma_m) * Eigen::Matrix2d::Identity(), 1e-9));
    EXPECT_NEAR(
        lost.rotation_rad2 - none.rotation_rad2, num_lost * square(kParams.lost_sigma_rad), 1e-12);
  }
}

TEST(MotionUncertainty, ScansThatRepeatTheOneBeforeWhileWheelsMoveAddNothing) {
  TrackedPose repeat = at({}, TrackStatus::kLost);
  repeat.sees_nothing_new = true;
  const MotionCovariance none = covariance_of({at({})});
  const MotionCovariance repeated = covariance_of({repeat, repeat, repeat, repeat, at({})});
  EXPECT_TRUE(repeated.translation_m2.isApprox(none.translation_m2, 1e-12));
  EXPECT_DOUBLE_EQ(repeated.rotation_rad2, none.rotation_rad2);
  EXPECT_DOUBLE_EQ(repeated.slip_sigma_m, 0.0);
}

TEST(MotionUncertainty, AnOpenDirectionCountsAlongItselfOnly) {
  constexpr double kOpen_rad = 0.7;
  const Eigen::Vector2d along(std::cos(kOpen_rad), std::sin(kOpen_rad));
  const Eigen::Vector2d across(-along.y(), along.x());
  const Pose2 end{0.4, 0.0, 0.0};
  const Eigen::Matrix2d bound = covariance_of({at({}), at(end)}, true).translation_m2;
  const Eigen::Matrix2d open =
      covariance_of({at({}), open_along(kOpen_rad, end)}, true).translation_m2;
  EXPECT_NEAR(across.dot(open * across), across.dot(bound * across), 1e-12);
  EXPECT_NEAR(along.dot(open * along) - along.dot(bound * along),
              square(kParams.open_sigma_per_metre_by_odometry * 0.4),
              1e-12);
}

// A robot that was seen to stand may have driven on since: what counts is the time, not the way of
// the estimate, which rests where the walls tell nothing.
TEST(MotionUncertainty, WithoutOdometryAnOpenDirectionGrowsWithTheTime) {
  const auto open_sigma_m = [](double speed_m_per_s, double seconds) {
    MotionUncertainty uncertainty(kParams);
    uncertainty.add(at({}), after(0.0));
    for (int i = 1; i <= static_cast<int>(10.0 * seconds); ++i) {
      uncertainty.add(open_along(0.0, {0.1 * i * speed_m_per_s, 0.0, 0.0}), after(0.1 * i));
    }
    return uncertainty.take().slip_sigma_m;
  };
  for (const double seconds : {0.5, 1.0, 1.5}) {  // while it may speed up
    EXPECT_NEAR(open_sigma_m(0.0, seconds),
                0.5 * kParams.open_acceleration_m_per_s2 * seconds * (seconds + 0.1),
                1e-9);
  }
  EXPECT_NEAR(
      open_sigma_m(0.0, 41.0) - open_sigma_m(0.0, 11.0), 30.0 * kParams.open_speed_m_per_s, 1e-9);
  EXPECT_EQ(open_sigma_m(0.0, 11.0), open_sigma_m(0.6, 11.0));
}

TEST(MotionUncertainty, AScanThatTellsTheSpeedEndsTheDoubt) {
  MotionUncertainty uncertainty(kParams);
  uncertainty.add(at({}), after(0.0));
  for (int i = 1; i <= 100; ++i) uncertainty.add(open_along(0.0, {}), after(0.1 * i));
  uncertainty.add(at({}), after(10.1));
  (void)uncertainty.take();
  uncertainty.add(open_along(0.0, {}), after(10.2));
  EXPECT_NEAR(
      uncertainty.take().slip_sigma_m, 0.1 * 0.1 * kParams.open_acceleration_m_per_s2, 1e-9);
}

// Between keyframes the error stays one: the graph is told which motions share it.
TEST(MotionUncertainty, MotionsOfOneOpenStretchAreToldApartFromThoseOfTheNext) {
  MotionUncertainty uncertainty(kParams);
  uncertainty.add(at({}), after(0.0));
  std::vector<MotionCovariance> motions;
  for (int i = 1; i <= 12; ++i) {
    const bool tells_speed = i == 7;
    uncertainty.add(tells_speed ? at({}) : open_along(0.3, {}), after(0.1 * i));
    if (i % 3 == 0) motions.push_back(uncertainty.take());
  }
  EXPECT_EQ(motions[0].open_stretch, motions[1].open_stretch);
  EXPECT_NE(motions[1].open_stretch, motions[2].open_stretch);
  EXPECT_EQ(motions[2].open_stretch, motions[3].open_stretch);
  for (const MotionCovariance& motion : motions) {
    EXPECT_GT(motion.open_sigma_m.trace(), 0.0);
    EXPECT_NEAR(motion.open_sigma_m.trace(), motion.slip_sigma_m, 1e-9);
  }
}

TEST(MotionUncertainty, WithOdometryErrorsOfKeyframesAreIndependent) {
  EXPECT_TRUE(
      covariance_of({at({}), open_along(0.3, {0.4, 0.0, 0.0})}, true).open_sigma_m.isZero(0.0));
}

TEST(MotionUncertainty, SigmasOfAnOpenDirectionAddUp) {
  // The same way in one scan or in eight: errors of neighbouring scans are correlated.
  std::vector<TrackedPose> many = {at({})};
  for (int i = 1; i <= 8; ++i) many.push_back(open_along(0.3, {0.05 * i, 0.0, 0.0}));
  const MotionCovariance in_eight = covariance_of(many, true);
  const MotionCovariance in_one = covariance_of({at({}), open_along(0.3, {0.4, 0.0, 0.0})}, true);
  EXPECT_TRUE(in_eight.translation_m2.isApprox(in_one.translation_m2, 1e-9));
}

TEST(MotionUncertainty, WhatAnotherScannerSawIsNotLost) {
  MotionUncertainty one_blind(kParams);
  MotionUncertainty both_blind(kParams);
  for (int i = 0; i < 10; ++i) {
    one_blind.add(at({}), {0, {}});
    one_blind.add(at({}, TrackStatus::kLost), {1, {}});
    both_blind.add(at({}, TrackStatus::kLost), {0, {}});
    both_blind.add(at({}, TrackStatus::kLost), {1, {}});
  }
  EXPECT_EQ(one_blind.take().translation_m2, covariance_of({at({})}).translation_m2);
  EXPECT_GT(both_blind.take().translation_m2.trace(), 10.0 * square(kParams.lost_sigma_m));
}

TEST(MotionUncertainty, OdometryReducesTheUncertainty) {
  TrackedPose restart = at({0.4, 0.0, 0.1}, TrackStatus::kLost);
  restart.is_restart = true;
  for (const TrackedPose& scan :
       {at({0.4, 0.0, 0.1}, TrackStatus::kLost), open_along(0.0, {0.04, 0.0, 0.1}), restart}) {
    const MotionCovariance with = covariance_of({at({}), scan}, true);
    const MotionCovariance without = covariance_of({at({}), scan}, false);
    EXPECT_LT(with.translation_m2.trace(), without.translation_m2.trace());
    EXPECT_LE(with.rotation_rad2, without.rotation_rad2);
  }
  // Where the walls determine the whole motion it changes nothing.
  const MotionCovariance with = covariance_of({at({}), at({0.4, 0.0, 0.1})}, true);
  const MotionCovariance without = covariance_of({at({}), at({0.4, 0.0, 0.1})}, false);
  EXPECT_EQ(with.translation_m2, without.translation_m2);
  EXPECT_EQ(with.rotation_rad2, without.rotation_rad2);
}

TEST(MotionUncertainty, ANewStartIsTheLeastCertainOfAll) {
  TrackedPose restart = at({}, TrackStatus::kLost);
  restart.is_restart = true;
  const MotionCovariance covariance = covariance_of({at({}), restart});
  EXPECT_GE(covariance.translation_m2(0, 0), square(kParams.restart_sigma_m));
  EXPECT_GE(covariance.rotation_rad2, square(kParams.restart_sigma_rad));
}

TEST(MotionUncertainty, OdometryBridgesANewStartOnlyWhereItNeverPaused) {
  for (const std::size_t without : {1U, 2U, 3U, 9U}) {
    MotionUncertainty uncertainty(kParams);
    for (std::size_t i = 0; i < 4; ++i) {
      TrackedPose scan = at({}, i == 0 ? TrackStatus::kTracked : TrackStatus::kLost);
      scan.has_odometry = i != without;
      scan.is_restart = i == 3;
      uncertainty.add(scan);
      if (i == 0) static_cast<void>(uncertainty.take());
    }
    const MotionCovariance covariance = uncertainty.take();
    const bool is_bridged = without > 3;
    EXPECT_EQ(covariance.has_odometry, is_bridged) << without;
    EXPECT_EQ(covariance.slip_sigma_m < kParams.restart_sigma_m, is_bridged) << without;
  }
}

TEST(MotionUncertainty, TakingRestartsTheSum) {
  MotionUncertainty uncertainty(kParams);
  uncertainty.add(at({}));
  uncertainty.add(at({1.0, 0.0, 0.0}, TrackStatus::kLost));
  uncertainty.add(at({2.0, 0.0, 0.0}, TrackStatus::kRecovered));
  uncertainty.add(open_along(0.3, {3.0, 0.0, 0.5}));
  (void)uncertainty.take();
  uncertainty.add(at({3.4, 0.0, 0.5}));
  const MotionCovariance second = uncertainty.take();
  const MotionCovariance alone = covariance_of({at({}), at({0.4, 0.0, 0.0})});
  EXPECT_TRUE(second.translation_m2.isApprox(alone.translation_m2, 1e-9));
  EXPECT_NEAR(second.rotation_rad2, alone.rotation_rad2, 1e-15);
}

TEST(MotionUncertainty, RefusesWhatIsNoSigma) {
  EXPECT_THROW(MotionUncertaintyParams{.step_sigma_m = 0.0}.validate(), ParameterError);
  EXPECT_THROW(MotionUncertaintyParams{.sigma_per_metre = -1.0}.validate(), ParameterError);
  EXPECT_THROW(MotionUncertaintyParams{.restart_sigma_m = 0.0}.validate(), ParameterError);
  EXPECT_THROW(MotionUncertaintyParams{.step_sigma_rad = 0.0}.validate(), ParameterError);
  EXPECT_NO_THROW(kParams.validate());
}

TEST(MotionUncertainty, WhereScansDepartFromProvedOdometryTheSpreadsAreToldAndNobodyElse) {
  TrackedPose departed = at({0.3, 0.0, 0.0});
  departed.departure = {.distance_m = 0.4, .turn_rad = 0.2};
  const MotionCovariance usual = covariance_of({at({}), at({0.3, 0.0, 0.0})}, true);
  const MotionCovariance covariance = covariance_of({at({}), departed}, true);
  EXPECT_NEAR(covariance.departure_sigma_m, 0.4, 1e-12);
  EXPECT_NEAR(covariance.departure_sigma_rad, 0.2, 1e-12);
  EXPECT_EQ(usual.departure_sigma_m, 0.0);
  EXPECT_EQ(usual.departure_sigma_rad, 0.0);
  EXPECT_EQ(covariance.translation_m2, usual.translation_m2);
  EXPECT_EQ(covariance.rotation_rad2, usual.rotation_rad2);
  EXPECT_EQ(covariance.slip_sigma_m, usual.slip_sigma_m);
}

// A scan that was sent again says nothing of the time since it came first: the robot drove on.
TEST(MotionUncertainty, CopiesOfAScanEndNoOpenStretch) {
  const Pose2 ahead{0.1, 0.0, 0.0};
  const auto open_sigma_m = [&](bool is_same_again) {
    MotionUncertainty uncertainty(kParams);
    uncertainty.add(at({}), after(0.0));
    uncertainty.add(open_along(0.0, ahead), after(1.0));
    TrackedPose copy = at(ahead);
    copy.is_same_again = is_same_again;
    for (const double stamp_s : {1.5, 2.0, 2.5}) uncertainty.add(copy, after(stamp_s));
    uncertainty.add(open_along(0.0, {0.2, 0.0, 0.0}), after(3.0));
    return uncertainty.take().open_sigma_m(0, 0);
  };
  MotionUncertainty only_new(kParams);
  only_new.add(at({}), after(0.0));
  only_new.add(open_along(0.0, ahead), after(1.0));
  only_new.add(open_along(0.0, {0.2, 0.0, 0.0}), after(3.0));
  EXPECT_EQ(open_sigma_m(true), only_new.take().open_sigma_m(0, 0));
  EXPECT_LT(open_sigma_m(false), 0.6 * open_sigma_m(true)) << "without the rule";
}

}  // namespace setsquare::motion_uncertainty_test
