// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/scan_tracker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "setsquare/core/error.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/simulated_drive.hpp"

namespace setsquare::scan_tracker_test {

using testing::bare_corridor;
using testing::between;
using testing::drive;
using testing::Fan;
using testing::l_shaped_room;
using testing::PoseNear;
using testing::PoseTolerance;
using testing::scans_on_drive;
using testing::way_around_the_room;

constexpr double kNoise_m = 0.01;

std::vector<TrackedPose> track_all(const std::vector<Scan>& scans,
                                   const std::vector<Pose2>& T_wheels_sensor = {}) {
  ScanTracker tracker;
  std::vector<TrackedPose> tracked;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    std::optional<Pose2> wheels;
    if (!T_wheels_sensor.empty()) wheels = T_wheels_sensor[i];
    tracked.push_back(tracker.track(scans[i], wheels));
  }
  return tracked;
}

class ScanTrackerInRoom : public ::testing::TestWithParam<Fan> {};

TEST_P(ScanTrackerInRoom, FollowsTheWayAround) {
  const std::vector<Pose2> truth = drive(way_around_the_room());
  const auto tracked = track_all(scans_on_drive(l_shaped_room(), truth, kNoise_m, GetParam()));
  for (std::size_t i = 0; i < truth.size(); ++i) {
    ASSERT_NE(tracked[i].status, TrackStatus::kLost) << i;
    ASSERT_THAT(tracked[i].T_odom_sensor,
                PoseNear(between(truth[0], truth[i]),
                         PoseTolerance{.translation_m = 0.05, .rotation_rad = rad_from_deg(0.6)}))
        << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Fans,
                         ScanTrackerInRoom,
                         ::testing::Values(Fan{},
                                           Fan{.num_beams = 180,
                                               .first_bearing_rad = 0.5 * kPi,
                                               .bearing_step_rad = -kPi / 180.0},
                                           Fan{.num_beams = 360, .first_bearing_rad = -kPi},
                                           Fan{.num_beams = 1081,
                                               .first_bearing_rad = rad_from_deg(-135.0),
                                               .bearing_step_rad = rad_from_deg(0.25)}));

/// How far apart the copies of a scan are placed that is sent five times along a bare corridor, to
/// a robot that drove on evenly, by odometry, which ends; with ranges that differ in their last
/// digits where not `is_exact`.
double farthest_copy_m(bool is_exact) {
  const std::vector<Pose2> truth = drive({{0.0, 0.1}, {8.0, 0.1}});
  const std::vector<Scan> scans = scans_on_drive(bare_corridor(), truth, kNoise_m);
  constexpr std::size_t kNumDriven = 20;
  ScanTracker tracker;
  for (std::size_t i = 0; i < kNumDriven; ++i) {
    (void)tracker.track(scans[i], between(truth[0], truth[i]));
  }
  std::vector<TrackedPose> copies;
  for (int copy = 0; copy < 5; ++copy) {
    Scan scan = scans[kNumDriven];
    if (!is_exact) scan.ranges_m.front() += 1e-9 * copy;
    copies.push_back(tracker.track(scan, std::nullopt));
  }
  return between(copies.front().T_odom_sensor, copies.back().T_odom_sensor).translation().norm();
}

// A driver sends what it has sent before: that is the same place again.
TEST(ScanTracker, TheSameScanIsOfTheSamePlace) {
  EXPECT_LT(farthest_copy_m(true), 0.02);
  EXPECT_GT(farthest_copy_m(false), 0.1) << "without the rule";
}

/// The scans, and the last of them `num` times more; with a range that differs in its last digits
/// where the copies are not `exact`.
std::vector<Scan> with_copies_of_last(std::vector<Scan> scans, std::size_t num, bool exact) {
  for (std::size_t copy = 1; copy <= num; ++copy) {
    scans.push_back(scans.back());
    if (!exact) scans.back().ranges_m.front() += 1e-9;
  }
  return scans;
}

// A scan that is found nowhere, or far off, is one witness however often it is sent.
TEST(ScanTracker, CopiesOfAScanNeitherRestartTheSubmapNorConfirmAPlace) {
  const std::vector<Scan> room =
      scans_on_drive(l_shaped_room(), drive({{1.5, 1.5}, {4.0, 1.5}}), kNoise_m);
  std::vector<Scan> carried = room;
  carried.push_back(
      scans_on_drive(testing::empty_rectangle(0.7, 0.9), {Pose2{0.3, 0.4, 0.1}}, kNoise_m).front());
  const auto num_restarts = [](const std::vector<TrackedPose>& tracked) {
    return std::ranges::count(tracked, true, &TrackedPose::is_restart);
  };
  EXPECT_EQ(num_restarts(track_all(with_copies_of_last(carried, 9, true))), 0);
  EXPECT_EQ(num_restarts(track_all(with_copies_of_last(carried, 9, false))), 1) << "without";

  std::vector<Scan> turned = room;
  turned.push_back(
      scans_on_drive(l_shaped_room(), {Pose2{4.3, 1.5, rad_from_deg(83.0)}}, kNoise_m).front());
  for (const bool exact : {true, false}) {
    const auto tracked = track_all(with_copies_of_last(turned, 3, exact));
    ASSERT_EQ(tracked[room.size()].status, TrackStatus::kRecovered);
    EXPECT_EQ(tracked.back().status, exact ? TrackStatus::kRecovered : TrackStatus::kTracked);
    EXPECT_EQ(tracked.back().is_same_again, exact);
  }
}

// The wheels move on between the copies, and are compared with the scans from new one to new one.
TEST(ScanTracker, OdometryProvesTrueWhereEachScanIsSentFiveTimes) {
  const std::vector<Pose2> truth = drive(way_around_the_room());
  std::vector<Scan> scans = scans_on_drive(l_shaped_room(), truth, kNoise_m);
  ScanTracker tracker;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    scans[i].ranges_m = scans[i - i % 5].ranges_m;
    (void)tracker.track(scans[i], truth[i]);
  }
  EXPECT_EQ(tracker.odometry().verdict, OdometryVerdict::kBelieved);
}

/// How far off the heading is of a scan at which the robot has turned by 25 degrees while the
/// odometry says that it turned the other way; where such a scan does not fit so badly that the
/// matcher is asked.
double heading_error_of_unexpected_turn_deg(ScanTrackerParams params) {
  params.recovery.below_score = params.recovery.below_score_if_open = -2.0;
  std::vector<Pose2> truth = drive({{1.5, 1.5}, {4.0, 1.5}});
  std::vector<Pose2> wheels = truth;
  truth.push_back(truth.back());
  wheels.push_back(wheels.back());
  truth.back().theta_rad += rad_from_deg(25.0);
  wheels.back().theta_rad -= rad_from_deg(25.0);
  const std::vector<Scan> scans = scans_on_drive(l_shaped_room(), truth, kNoise_m);
  ScanTracker tracker(params);
  TrackedPose tracked;
  for (std::size_t i = 0; i < scans.size(); ++i) tracked = tracker.track(scans[i], wheels[i]);
  return std::abs(deg_from_rad(
      wrap_to_pi(tracked.T_odom_sensor.theta_rad - between(truth[0], truth.back()).theta_rad)));
}

TEST(ScanTracker, ATurnThatNobodyExpectedIsFound) {
  ScanTrackerParams without;
  without.deskew.sudden_turn.below_score = -2.0;
  EXPECT_LT(heading_error_of_unexpected_turn_deg({}), 0.6);
  EXPECT_GT(heading_error_of_unexpected_turn_deg(without), 5.0) << "without the rule";
}

TEST(ScanTracker, KeepsKeyframesAtTheirSpacing) {
  const std::vector<Pose2> truth = drive({{1.0, 1.0}, {5.0, 1.0}});
  const auto tracked = track_all(scans_on_drive(l_shaped_room(), truth, kNoise_m));
  std::size_t num_keyframes = 0;
  for (const TrackedPose& pose : tracked) num_keyframes += pose.is_keyframe;
  EXPECT_TRUE(tracked.front().is_keyframe);
  EXPECT_GE(num_keyframes, 9U);  // 4 m in steps of 0.45 m, as 0.4 m has to be exceeded
  EXPECT_LE(num_keyframes, 11U);
}

TEST(ScanTracker, SaysThatABareCorridorLeavesItsDirectionOpen) {
  const std::vector<Pose2> truth = drive({{0.0, 0.1}, {3.0, 0.1}});
  const auto tracked = track_all(scans_on_drive(bare_corridor(), truth, kNoise_m));
  for (std::size_t i = 1; i < tracked.size(); ++i) {
    EXPECT_EQ(tracked[i].status, TrackStatus::kDegenerate) << i;
    EXPECT_GT(std::abs(tracked[i].open.direction.x()), 0.999) << "along the corridor";
    EXPECT_NEAR(tracked[i].T_odom_sensor.y_m, 0.0, 0.03) << "across it the walls bind";
  }
}

TEST(ScanTracker, AlongABareCorridorTheOdometryIsTrusted) {
  const std::vector<Pose2> truth = drive({{0.0, 0.1}, {6.0, 0.1}});
  const auto tracked = track_all(scans_on_drive(bare_corridor(), truth, kNoise_m), truth);
  EXPECT_NEAR(tracked.back().T_odom_sensor.x_m, 6.0, 0.3);
}

TEST(ScanTracker, OdometryOfTheWrongSignDoesNoHarmWhereWallsBind) {
  const std::vector<Pose2> truth = drive(way_around_the_room());
  std::vector<Pose2> wheels{truth[0]};
  for (std::size_t i = 1; i < truth.size(); ++i) {
    Pose2 step = between(truth[i - 1], truth[i]);
    if (i % 3 != 0) step.x_m = -step.x_m;
    wheels.push_back(wheels.back() * step);
  }
  const auto tracked = track_all(scans_on_drive(l_shaped_room(), truth, kNoise_m), wheels);
  EXPECT_THAT(tracked.back().T_odom_sensor,
              PoseNear(between(truth.front(), truth.back()),
                       PoseTolerance{.translation_m = 0.05, .rotation_rad = rad_from_deg(0.6)}));
}

TEST(ScanTracker, FindsItselfAgainAfterAGapWithALargeTurn) {
  std::vector<Pose2> truth = drive({{1.5, 1.5}, {4.0, 1.5}});
  Pose2 after_gap = truth.back();
  after_gap.theta_rad = rad_from_deg(83.0);
  after_gap.x_m += 0.3;
  for (int i = 0; i < 5; ++i) truth.push_back(after_gap);
  const auto tracked = track_all(scans_on_drive(l_shaped_room(), truth, kNoise_m));
  EXPECT_EQ(tracked[truth.size() - 5].status, TrackStatus::kRecovered);
  EXPECT_EQ(tracked.back().status, TrackStatus::kTracked);
  EXPECT_THAT(tracked.back().T_odom_sensor,
              PoseNear(between(truth.front(), truth.back()),
                       PoseTolerance{.translation_m = 0.05, .rotation_rad = rad_from_deg(0.6)}));
}

TEST(ScanTracker, BlindScansAreLostAndTheWayGoesOn) {
  const std::vector<Pose2> truth = drive({{1.5, 1.5}, {5.0, 1.5}});
  std::vector<Scan> scans = scans_on_drive(l_shaped_room(), truth, kNoise_m);
  for (std::size_t i = 30; i < 33; ++i) scans[i].ranges_m.assign(180, 81.83);
  const auto tracked = track_all(scans);
  for (std::size_t i = 30; i < 33; ++i) EXPECT_EQ(tracked[i].status, TrackStatus::kLost);
  EXPECT_THAT(tracked.back().T_odom_sensor,
              PoseNear(between(truth.front(), truth.back()),
                       PoseTolerance{.translation_m = 0.05, .rotation_rad = rad_from_deg(0.6)}));
}

void make_blank(Scan& scan) {
  scan.ranges_m.assign(scan.ranges_m.size(), std::numeric_limits<double>::quiet_NaN());
}

/// The blank scans are lost and leave no trace; all others are placed, without a restart.
void expect_only_blanks_are_lost(const std::vector<TrackedPose>& tracked,
                                 std::size_t first_blank,
                                 std::size_t num_blank) {
  for (std::size_t i = 0; i < tracked.size(); ++i) {
    const bool is_blank = i >= first_blank && i < first_blank + num_blank;
    EXPECT_EQ(tracked[i].status == TrackStatus::kLost, is_blank) << i;
    EXPECT_FALSE(tracked[i].is_restart) << i;
    if (!is_blank) continue;
    EXPECT_FALSE(tracked[i].is_keyframe) << i;
    EXPECT_EQ(tracked[i].score, 0.0) << i;
  }
}

TEST(ScanTracker, BlankScansAtTheStartCostNoOther) {
  const std::vector<Pose2> truth = drive({{1.5, 1.5}, {4.5, 1.5}});
  for (const std::size_t num_blank : {1U, 4U, 5U, 12U}) {
    std::vector<Scan> scans = scans_on_drive(l_shaped_room(), truth, kNoise_m);
    for (std::size_t i = 0; i < num_blank; ++i) make_blank(scans[i]);
    const auto tracked = track_all(scans);
    expect_only_blanks_are_lost(tracked, 0, num_blank);
    EXPECT_TRUE(tracked[num_blank].is_keyframe);
    EXPECT_EQ(tracked[num_blank].T_odom_sensor, Pose2{});
    EXPECT_THAT(tracked.back().T_odom_sensor,
                PoseNear(between(truth[num_blank], truth.back()),
                         PoseTolerance{.translation_m = 0.05, .rotation_rad = rad_from_deg(0.6)}));
  }
}

TEST(ScanTracker, AfterBlankScansAtTheStartTheOdometryDeterminesWhereTheSubmapBegins) {
  const std::vector<Pose2> truth = drive({{1.5, 1.5}, {4.5, 1.5}});
  std::vector<Scan> scans = scans_on_drive(l_shaped_room(), truth, kNoise_m);
  for (std::size_t i = 0; i < 10; ++i) make_blank(scans[i]);
  const auto tracked = track_all(scans, truth);
  EXPECT_TRUE(tracked[10].is_keyframe);
  EXPECT_THAT(tracked[10].T_odom_sensor,
              PoseNear(between(truth[0], truth[10]),
                       PoseTolerance{.translation_m = 1e-9, .rotation_rad = 1e-9}));
}

TEST(ScanTracker, BlankScansOnTheWayCostNoOther) {
  const std::vector<Pose2> truth = drive({{1.5, 1.5}, {5.0, 1.5}});
  for (const std::size_t num_blank : {5U, 6U, 7U, 12U}) {
    std::vector<Scan> scans = scans_on_drive(l_shaped_room(), truth, kNoise_m);
    for (std::size_t i = 30; i < 30 + num_blank; ++i) make_blank(scans[i]);
    const auto tracked = track_all(scans);
    expect_only_blanks_are_lost(tracked, 30, num_blank);
    EXPECT_THAT(tracked.back().T_odom_sensor,
                PoseNear(between(truth.front(), truth.back()),
                         PoseTolerance{.translation_m = 0.05, .rotation_rad = rad_from_deg(0.6)}));
  }
}

TEST(ScanTracker, RestartsWhereItStaysLost) {
  const std::vector<Pose2> truth = drive({{1.5, 1.5}, {4.0, 1.5}});
  std::vector<Scan> scans = scans_on_drive(l_shaped_room(), truth, kNoise_m);
  // Carried into another building.
  const std::vector<Pose2> elsewhere(12, Pose2{0.0, 0.0, 0.0});
  const std::vector<testing::Wall> other{{0.4, -0.5, 0.6, 0.1},
                                         {0.6, 0.1, 0.3, 0.2},
                                         {0.3, 0.2, 0.5, 0.6},
                                         {0.5, 0.6, -0.2, 0.5},
                                         {-0.2, -0.4, 0.4, -0.5}};
  for (Scan& scan : scans_on_drive(other, elsewhere, kNoise_m)) scans.push_back(scan);
  const auto tracked = track_all(scans);
  std::size_t num_restarts = 0;
  for (const TrackedPose& pose : tracked) num_restarts += pose.is_restart;
  EXPECT_EQ(num_restarts, 1U);
  EXPECT_TRUE(tracked[truth.size() + 4].is_restart) << "the fifth scan that nothing explains";
  EXPECT_NE(tracked.back().status, TrackStatus::kLost);
}

TEST(ScanTracker, AMotionThatWasLostDoesNotContinueAfterARestart) {
  const std::vector<Pose2> truth = drive({{1.5, 1.5}, {5.0, 1.5}});
  std::vector<Scan> scans = scans_on_drive(l_shaped_room(), truth, kNoise_m);
  const std::size_t carried_at = 60;  // At full speed.
  ASSERT_LT(carried_at, scans.size());
  scans.resize(carried_at);
  for (Scan& scan :
       scans_on_drive(testing::empty_rectangle(0.7, 0.9), {5, Pose2{0.3, 0.4, 0.1}}, kNoise_m)) {
    scans.push_back(scan);
  }
  scans.push_back(scans.back());
  make_blank(scans.back());
  const auto tracked = track_all(scans);
  const TrackedPose& restart = tracked[carried_at + 4];
  ASSERT_TRUE(restart.is_restart);
  EXPECT_EQ(tracked.back().T_odom_sensor, restart.T_odom_sensor) << "as if it had gone on";
}

TEST(ScanTracker, NamesABadParameter) {
  ScanTrackerParams params;
  params.num_keyframes = 0;
  EXPECT_THROW(ScanTracker{params}, ParameterError);
  params = {};
  params.keyframe_distance_m = 0.0;
  EXPECT_THROW(ScanTracker{params}, ParameterError);
}

}  // namespace setsquare::scan_tracker_test
