// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/bag/pose_history.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "tests/support/pose_matchers.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::pose_history_test {
namespace {

using ::testing::Eq;
using testing::make_generator;
using ::testing::Optional;
using testing::uniform;

Timestamp at_s(double seconds) { return timestamp_from_seconds(seconds); }

TEST(PoseHistory, KnowsNothingWhenEmpty) {
  EXPECT_THAT(PoseHistory().at(at_s(1.0)), Eq(std::nullopt));
  EXPECT_FALSE(PoseHistory().reaches(at_s(-1.0)));
}

TEST(PoseHistory, GivesAPoseExactlyAtItsStamp) {
  PoseHistory history;
  const Pose2 first{0.1, 0.2, 0.3};
  const Pose2 second{1.0 / 3.0, -7.1, -3.1};
  history.add(at_s(10.0), first);
  history.add(at_s(10.1), second);
  EXPECT_THAT(history.at(at_s(10.0)), Optional(Eq(first)));
  EXPECT_THAT(history.at(at_s(10.1)), Optional(Eq(second)));
}

TEST(PoseHistory, InterpolatesAlongTheShorterTurn) {
  PoseHistory history;
  history.add(at_s(0.0), {0.0, 0.0, 3.0});
  history.add(at_s(0.4), {4.0, -8.0, -3.0});
  const std::optional<Pose2> pose = history.at(at_s(0.1));
  ASSERT_TRUE(pose.has_value());
  EXPECT_NEAR(pose->x_m, 1.0, 1e-12);
  EXPECT_NEAR(pose->y_m, -2.0, 1e-12);
  EXPECT_NEAR(pose->theta_rad, 3.0 + 0.25 * (kTwoPi - 6.0), 1e-12);
}

TEST(PoseHistory, DoesNotInterpolateAcrossAGap) {
  PoseHistory history;
  history.add(at_s(0.0), {0.0, 0.0, 0.0});
  history.add(at_s(10.0), {10.0, 0.0, 0.0});
  EXPECT_THAT(history.at(at_s(5.0)), Eq(std::nullopt));
  EXPECT_THAT(history.at(at_s(0.1)), Optional(Eq(Pose2{0.0, 0.0, 0.0})));
  EXPECT_THAT(history.at(at_s(9.9)), Optional(Eq(Pose2{10.0, 0.0, 0.0})));
}

TEST(PoseHistory, TakesTheNearestBeyondItsEndsForAWhile) {
  PoseHistory history;
  history.add(at_s(5.0), {1.0, 0.0, 0.0});
  EXPECT_TRUE(history.at(at_s(5.4)).has_value());
  EXPECT_TRUE(history.at(at_s(4.6)).has_value());
  EXPECT_FALSE(history.at(at_s(6.0)).has_value());
  EXPECT_FALSE(history.at(at_s(4.0)).has_value());
}

TEST(PoseHistory, BeginsAgainWhereTheClockJumpsBack) {
  PoseHistory history;
  history.add(at_s(100.0), {1.0, 0.0, 0.0});
  history.add(at_s(99.9), {2.0, 0.0, 0.0});  // a little older
  EXPECT_THAT(history.at(at_s(99.9)), Optional(Eq(Pose2{2.0, 0.0, 0.0})));
  EXPECT_THAT(history.at(at_s(100.0)), Optional(Eq(Pose2{1.0, 0.0, 0.0})));
  history.add(at_s(3.0), {3.0, 0.0, 0.0});
  EXPECT_FALSE(history.at(at_s(100.0)).has_value());
  EXPECT_THAT(history.at(at_s(3.0)), Optional(Eq(Pose2{3.0, 0.0, 0.0})));
}

// Law: at any moment between two poses the pose lies between them, and in proportion to the time.
TEST(PoseHistory, InterpolationIsProportional) {
  auto generator = make_generator();
  for (int trial = 0; trial < 200; ++trial) {
    PoseHistory history;
    const double gap_s = uniform(generator, 0.01, PoseHistory::kMaxGap_s);
    const Pose2 to{uniform(generator, -1, 1), uniform(generator, -1, 1), uniform(generator, -3, 3)};
    history.add(at_s(0.0), {});
    history.add(at_s(gap_s), to);
    const double share = uniform(generator, 0.0, 1.0);
    const std::optional<Pose2> pose = history.at(at_s(share * gap_s));
    ASSERT_TRUE(pose.has_value());
    EXPECT_NEAR(pose->x_m, share * to.x_m, 1e-6);
    EXPECT_NEAR(pose->y_m, share * to.y_m, 1e-6);
    EXPECT_NEAR(pose->theta_rad, share * to.theta_rad, 1e-6);
  }
}

}  // namespace
}  // namespace setsquare::pose_history_test
