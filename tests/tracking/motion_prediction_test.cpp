// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/motion_prediction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
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

TEST(MotionPrediction, GoesOnToTheScansOfAnotherScannerByTheStamps) {
  // Two scanners, the second one 20 ms behind the first, on an arc at constant speed.
  const auto pose_at = [](double time_s) {
    const double heading_rad = 0.8 * time_s;
    return Pose2{std::sin(heading_rad), 1.0 - std::cos(heading_rad), wrap_to_pi(heading_rad)};
  };
  const auto sweep_at = [](std::uint32_t scanner, double time_s) {
    return SweepStart{scanner, {static_cast<std::int64_t>(std::llround(1e9 * time_s))}};
  };
  MotionPrediction motion(7);
  for (int i = 0; i < 30; ++i) {
    for (const std::uint32_t scanner : {0U, 1U}) {
      const double time_s = 0.1 * i + 0.02 * scanner;
      if (i > 10) {
        EXPECT_THAT(
            motion.next(std::nullopt, sweep_at(scanner, time_s)),
            PoseNear(pose_at(time_s), PoseTolerance{.translation_m = 2e-3, .rotation_rad = 1e-6}))
            << time_s;
      }
      motion.add(pose_at(time_s), std::nullopt, sweep_at(scanner, time_s));
    }
  }
}

}  // namespace setsquare::motion_prediction_test
