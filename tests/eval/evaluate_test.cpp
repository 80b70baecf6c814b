// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/evaluate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "setsquare/core/error.hpp"

namespace setsquare::evaluate_test {

Trajectory arc(const Pose2& T_frame_start) {
  Trajectory trajectory;
  for (int i = 0; i < 20; ++i) {
    const double turn_rad = 0.1 * i;
    trajectory.push_back(
        {timestamp_from_seconds(100.0 + i),
         T_frame_start *
             Pose2{3.0 * std::sin(turn_rad), 3.0 - 3.0 * std::cos(turn_rad), turn_rad}});
  }
  return trajectory;
}

TEST(Evaluate, AnotherFrameIsNoError) {
  const AbsoluteTrajectoryError error = evaluate(arc({5.0, -2.0, 1.0}), arc({}));
  EXPECT_EQ(error.translation_m.num_values, 20U);
  EXPECT_LT(error.translation_m.max, 1e-9);
  EXPECT_LT(error.rotation_rad.max, 1e-9);
}

TEST(Evaluate, RelationsMeasureWhatLiesBetweenTwoPoses) {
  const Trajectory trajectory = arc({});
  const Relation relation{.reference_stamp = trajectory[2].stamp,
                          .current_stamp = trajectory[9].stamp,
                          .T_reference_current = trajectory[2].pose.inverse() * trajectory[9].pose *
                                                 Pose2{0.03, 0.04, 0.0}};
  const RelationErrorReport report = evaluate(trajectory, {&relation, 1});
  EXPECT_EQ(report.all.num_relations, 1U);
  EXPECT_NEAR(report.all.translation_m.mean, 0.05, 1e-9);
}

TEST(Evaluate, NothingInCommonIsAnErrorOfTheCaller) {
  Trajectory later = arc({});
  for (StampedPose& pose : later) pose.stamp.ns += 1'000'000'000'000;
  EXPECT_THROW((void)evaluate(arc({}), later), ParameterError);
}

}  // namespace setsquare::evaluate_test
