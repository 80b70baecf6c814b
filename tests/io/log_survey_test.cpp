// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/log_survey.hpp"

#include <gtest/gtest.h>

namespace setsquare::log_survey_test {

Timestamp seconds(double value) { return timestamp_from_seconds(value); }

LogRecord odometry(double stamp_s, const Pose2& T_odom_base, double forward_m_per_s) {
  LogRecord record;
  record.kind = RecordKind::kOdometry;
  record.stamp = seconds(stamp_s);
  record.T_odom_base = T_odom_base;
  record.forward_m_per_s = forward_m_per_s;
  record.position = static_cast<std::uint64_t>(stamp_s);
  return record;
}

TEST(StampSurvey, BackwardRepeatedAndGaps) {
  StampSurvey survey;
  for (const double stamp_s : {10.0, 11.0, 10.5, 10.5, 14.0, 13.25}) survey.add(seconds(stamp_s));
  EXPECT_EQ(survey.num_stamps, 6U);
  EXPECT_EQ(survey.num_backward, 2U);
  EXPECT_DOUBLE_EQ(survey.largest_backward_s, 0.75);
  EXPECT_EQ(survey.num_repeated, 1U);
  EXPECT_DOUBLE_EQ(survey.longest_gap_s, 3.5);
  EXPECT_DOUBLE_EQ(survey.duration_s(), 4.0);
}

TEST(SensorSurvey, CountsOutcomesCodesAndUnchangedScans) {
  Scan scan;
  scan.bearing_step_rad = 0.1;
  scan.max_range_m = 50.0;
  scan.ranges_m = {1.0, 2.5, 50.0, 81.91, 81.91, 0.0};
  SensorSurvey survey;
  survey.add(scan);
  survey.add(scan);
  EXPECT_EQ(survey.num_returns, 4U);
  EXPECT_EQ(survey.num_no_returns, 6U);
  EXPECT_EQ(survey.num_invalid, 2U);
  EXPECT_EQ(survey.codes.at(81.91), 4U);
  EXPECT_EQ(survey.codes.at(50.0), 2U);
  EXPECT_EQ(survey.return_range_m.low, 1.0);
  EXPECT_EQ(survey.return_range_m.high, 2.5);
  EXPECT_EQ(survey.num_unchanged, 1U);
}

TEST(SensorSurvey, CodesAreBounded) {
  Scan scan;
  scan.bearing_step_rad = 1e-4;
  scan.max_range_m = 50.0;
  for (int i = 0; i < 1000; ++i) scan.ranges_m.push_back(60.0 + 0.01 * i);
  SensorSurvey survey;
  survey.add(scan);
  EXPECT_EQ(survey.codes.size(), SensorSurvey::kMaxCodes);
  EXPECT_EQ(survey.num_no_returns, 1000U);
}

TEST(OdometrySurvey, PathAndTurns) {
  OdometrySurvey survey;
  survey.add(odometry(0.0, {0.0, 0.0, 3.1}, 0.3));
  survey.add(odometry(1.0, {0.3, 0.4, -3.1}, 0.3));
  survey.add(odometry(2.0, {0.3, 0.4, -3.1}, 0.0));
  EXPECT_NEAR(survey.path_m, 0.5, 1e-12);
  EXPECT_NEAR(survey.turn_rad, kTwoPi - 6.2, 1e-12);
  EXPECT_EQ(survey.num_still, 1U);
  EXPECT_EQ(survey.num_jumps, 0U);
}

TEST(OdometrySurvey, AJumpIsFasterThanAnyRobot) {
  OdometrySurvey survey;
  survey.add(odometry(1.0, {0.0, 0.0, 0.0}, 0.0));
  survey.add(odometry(2.0, {4.0, 0.0, 0.0}, 0.0));    // fast, but possible
  survey.add(odometry(3.0, {10.0, 0.0, 0.0}, 0.0));   // 6 m in a second
  survey.add(odometry(3.01, {10.0, 0.0, 1.0}, 0.0));  // 57 degrees in 10 ms
  EXPECT_EQ(survey.num_jumps, 2U);
  EXPECT_EQ(survey.first_jump, seconds(3.0));
}

// Driving backwards, the pose of some logs goes forwards.
TEST(OdometrySurvey, ASignContradictionNeedsBothSpeedsAndAStep) {
  OdometrySurvey survey;
  survey.add(odometry(0.0, {0.0, 0.0, 0.0}, 0.2));
  survey.add(odometry(1.0, {0.1, 0.0, 0.0}, 0.2));    // forwards, as reported
  survey.add(odometry(2.0, {0.15, 0.0, 0.0}, -0.2));  // turning round: one speed only
  survey.add(odometry(3.0, {0.25, 0.0, 0.0}, -0.2));  // backwards reported, forwards moved
  survey.add(odometry(4.0, {0.25, 0.0, 0.0}, -0.2));  // no step
  survey.add(odometry(5.0, {0.15, 0.0, 0.0}, -0.2));  // backwards, as reported
  EXPECT_EQ(survey.num_sign_contradictions, 1U);
  EXPECT_EQ(survey.first_contradiction, seconds(3.0));
}

TEST(LogSurvey, KeepsLasersApart) {
  LogSurvey survey;
  LogRecord record;
  record.scan.bearing_step_rad = 0.1;
  record.scan.ranges_m = {1.0, 2.0};
  for (const char* sensor : {"FLASER", "RLASER", "FLASER"}) {
    record.sensor = sensor;
    survey.add(record);
  }
  EXPECT_EQ(survey.sensors.at("FLASER").stamps.num_stamps, 2U);
  EXPECT_EQ(survey.sensors.at("RLASER").stamps.num_stamps, 1U);
}

}  // namespace setsquare::log_survey_test
