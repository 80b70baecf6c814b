// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/motion_prediction.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "tests/support/pose_matchers.hpp"

namespace setsquare::motion_prediction_test {

using testing::PoseNear;
using testing::PoseTolerance;

TEST(MotionPrediction, ContinuesAStraightLineAndAnArc) {
  for (const Pose2& step : {Pose2{0.1, 0.0, 0.0}, Pose2{0.1, 0.0, 0.05}, Pose2{0.0, 0.0, -0.1}}) {
    MotionPrediction motion(7);
    Pose2 pose{1.0, 2.0, 0.5};
    for (int i = 0; i < 20; ++i) {
      motion.add(pose, std::nullopt);
      pose = pose * step;
    }
    // The mean over an arc is its chord, a little shorter: 0.1 m * (1 - sinc(7 * 0.025)).
    EXPECT_THAT(motion.next(std::nullopt),
                PoseNear(pose, PoseTolerance{.translation_m = 6e-4, .rotation_rad = 1e-12}));
  }
}

TEST(MotionPrediction, OdometryGoesFirst) {
  MotionPrediction motion(3);
  const Pose2 wheels{5.0, -1.0, 2.0};
  motion.add({0.0, 0.0, 0.0}, wheels);
  motion.add({1.0, 0.0, 0.0}, wheels);
  const Pose2 moved{0.02, 0.01, 0.3};
  EXPECT_THAT(motion.next(wheels * moved), PoseNear(Pose2{1.02, 0.01, 0.3}, PoseTolerance{}));
  EXPECT_THAT(motion.next(std::nullopt), PoseNear(Pose2{2.0, 0.0, 0.0}, PoseTolerance{}));
}

TEST(MotionPrediction, StandsStillAtTheBeginningAndAfterARestart) {
  MotionPrediction motion(3);
  motion.add({1.0, 1.0, 0.2}, std::nullopt);
  EXPECT_EQ(motion.next(std::nullopt), (Pose2{1.0, 1.0, 0.2}));
  motion.add({2.0, 1.0, 0.2}, std::nullopt);
  motion.restart();
  EXPECT_EQ(motion.next(std::nullopt), (Pose2{2.0, 1.0, 0.2}));
}

}  // namespace setsquare::motion_prediction_test
