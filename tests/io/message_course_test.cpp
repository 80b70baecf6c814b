// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/bag/message_course.hpp"

#include <gtest/gtest.h>

#include <string>

namespace setsquare::message_course_test {

Timestamp at(double seconds) { return timestamp_from_seconds(1e9 + seconds); }

CourseMessage message(double stamp_s,
                      double log_time_s,
                      double x_m = 0.0,
                      const std::string& frames = "odom base") {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation().x() = x_m;
  return {.stamp = at(stamp_s), .log_time = at(log_time_s), .frames = frames, .pose = pose};
}

class LiveCourse : public ::testing::Test {
 protected:
  [[nodiscard]] bool takes(const CourseMessage& one) { return course_.fault_of(one).empty(); }
  /// A robot that drives by 1 m/s, ten messages a second.
  void drive(double from_s, double to_s) {
    for (double t_s = from_s; t_s < to_s - 1e-6; t_s += 0.1) {
      EXPECT_TRUE(takes(message(t_s, t_s, t_s))) << t_s;
    }
  }

  MessageCourse course_{true};
};

TEST_F(LiveCourse, ARobotThatDrivesIsBelieved) { drive(0.0, 20.0); }

TEST_F(LiveCourse, WhatDoesNotGoOnIsLeftOutAndTheRobotGoesOn) {
  drive(0.0, 2.0);
  for (int k = 0; k < 1000; ++k) {
    EXPECT_FALSE(takes(message(2.0 + 1e8, 2.0, 2.0)));
    EXPECT_FALSE(takes(message(2.0 - 5.0 * k - 5.0, 2.0, 2.0)));
    EXPECT_FALSE(takes(message(2.0, 2.0, 10.0 * (k + 1))));
    EXPECT_FALSE(takes(message(2.0, 2.0, 2.0, "map base")));
    if (k % 100 == 0) drive(2.0 + 1e-3 * k, 2.0 + 1e-3 * k + 0.1);
  }
  drive(3.0, 5.0);
}

TEST_F(LiveCourse, OfTwoThatSpeakInTurnsTheFirstCounts) {
  drive(0.0, 1.0);
  for (double t_s = 1.0; t_s < 10.0; t_s += 0.1) {
    EXPECT_TRUE(takes(message(t_s, t_s, t_s)));
    EXPECT_FALSE(takes(message(t_s, t_s, t_s + 5.0)));
  }
}

TEST_F(LiveCourse, AnOdometryThatBeginsAgainIsBelievedAfterHalfASecond) {
  drive(0.0, 30.0);
  for (double t_s = 30.0; t_s < 30.45; t_s += 0.1) EXPECT_FALSE(takes(message(t_s, t_s, 0.0)));
  for (double t_s = 30.51; t_s < 32.0; t_s += 0.1) EXPECT_TRUE(takes(message(t_s, t_s, 0.0)));
}

TEST_F(LiveCourse, ALogThatIsPlayedAgainIsBelievedAfterHalfASecond) {
  drive(100.0, 110.0);
  for (double t_s = 0.0; t_s < 0.45; t_s += 0.1) {
    EXPECT_FALSE(takes(message(t_s, 110.0 + t_s, t_s)));
  }
  for (double t_s = 0.51; t_s < 2.0; t_s += 0.1) EXPECT_TRUE(takes(message(t_s, 110.0 + t_s, t_s)));
}

TEST_F(LiveCourse, APauseIsNoJump) {
  drive(0.0, 1.0);
  drive(500.0, 501.0);
}

TEST_F(LiveCourse, WhoeverLiesFirstIsForgottenAsSoonAsOthersGoOn) {
  EXPECT_TRUE(takes(message(1e8, 0.0, 50.0)));
  EXPECT_FALSE(takes(message(0.0, 0.0, 0.0)));
  EXPECT_FALSE(takes(message(3e8, 0.05, 20.0)));
  EXPECT_TRUE(takes(message(0.1, 0.1, 0.1)));
  drive(0.2, 2.0);
}

TEST_F(LiveCourse, AFrameOfTheRobotMayFollowAnother) {
  drive(0.0, 1.0);
  CourseMessage other = message(1.0, 1.0, 1.0, "laser_left");
  EXPECT_FALSE(takes(other));
  other.is_placed = true;
  EXPECT_TRUE(takes(other));
}

/// Log times that mean nothing: a recording that was made in no time, of a robot that stood still
/// now and then, or of key frames.
TEST(FileCourse, PausesAreBelievedWhateverTheLogTimesAre) {
  for (const double step_s : {0.1, 3.0}) {
    MessageCourse course(false);
    double stamp_s = 0.0;
    for (int k = 0; k < 200; ++k) {
      stamp_s += k % 50 == 49 ? 100.0 : step_s;
      EXPECT_EQ(course.fault_of(message(stamp_s, 1e-5 * k)), "") << k;
    }
  }
}

TEST(FileCourse, WhatNeverGoesOnCannotBeJudged) {
  MessageCourse course(false);
  for (int k = 0; k < 100; ++k) {
    EXPECT_EQ(course.fault_of(message(0.1 * k, 0.1 * k, k % 2 == 0 ? 0.0 : 9.0)), "") << k;
  }
}

TEST(FileCourse, YearsAheadAreLeftOut) {
  MessageCourse course(false);
  for (int k = 0; k < 100; ++k) {
    EXPECT_EQ(course.fault_of(message(0.1 * k, 0.1 * k)), "") << k;
    if (k > 3) {
      EXPECT_NE(course.fault_of(message(1e8, 0.1 * k)), "");
    }
  }
}

}  // namespace setsquare::message_course_test
