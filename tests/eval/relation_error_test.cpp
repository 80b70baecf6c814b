// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/relation_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/seed.hpp"

namespace setsquare::relation_error_test {

Timestamp stamp(double seconds) { return timestamp_from_seconds(seconds); }

Pose2 random_pose(std::mt19937_64& generator) {
  return {testing::uniform(generator, -20.0, 20.0),
          testing::uniform(generator, -20.0, 20.0),
          testing::uniform(generator, -kPi, kPi)};
}

TEST(RelationError, ATrajectoryThatFulfilsItsRelationsHasNone) {
  auto generator = testing::make_generator();
  Trajectory trajectory;
  for (int i = 0; i < 100; ++i) trajectory.push_back({stamp(i), random_pose(generator)});
  std::vector<Relation> relations;
  for (int i = 0; i < 100; i += 3) {
    const int j = (i * 7 + 31) % 100;
    relations.push_back({stamp(i), stamp(j), trajectory[i].pose.inverse() * trajectory[j].pose});
  }
  const RelationErrorReport report = relation_error(trajectory, relations);
  EXPECT_EQ(report.all.num_relations, relations.size());
  EXPECT_LT(report.all.translation_m.mean, 1e-12);
  EXPECT_LT(report.all.rotation_rad.mean, 1e-12);
  EXPECT_EQ(report.num_missing, 0U);
}

// By hand: e = (p1^-1 p2) d^-1 for p1 = identity.
TEST(RelationError, ErrorsMeansAndSampleDeviations) {
  const Trajectory trajectory = {
      {stamp(0.0), {}}, {stamp(1.0), {1.0, 0.0, 0.0}}, {stamp(2.0), {2.0, 0.0, kPi / 2.0}}};
  const std::vector<Relation> relations = {
      {stamp(0.0), stamp(1.0), {0.9, 0.0, 0.0}},              // 0.1 m, 0 rad
      {stamp(0.0), stamp(2.0), {2.0, 0.0, kPi / 2.0 - 0.2}},  // turned by 0.2 about the origin
  };
  const RelationErrors errors = relation_error(trajectory, relations).all;
  const double second_m = 2.0 * 2.0 * std::sin(0.1);  // d's far end, 2 m out, turned by 0.2 rad
  EXPECT_NEAR(errors.translation_m.mean, 0.5 * (0.1 + second_m), 1e-12);
  EXPECT_NEAR(errors.translation_m.deviation, (second_m - 0.1) / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(errors.squared_translation_m2.mean, 0.5 * (0.01 + second_m * second_m), 1e-12);
  EXPECT_NEAR(errors.rotation_rad.mean, 0.1, 1e-12);
  EXPECT_NEAR(errors.rotation_rad.deviation, 0.2 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(errors.squared_rotation_rad2.mean, 0.02, 1e-12);
}

TEST(RelationError, DoesNotDependOnTheFrameOrTheOrderOfTheTrajectory) {
  auto generator = testing::make_generator();
  Trajectory trajectory;
  for (int i = 0; i < 50; ++i) trajectory.push_back({stamp(i), random_pose(generator)});
  std::vector<Relation> relations;
  for (int i = 0; i + 5 < 50; ++i) {
    relations.push_back({stamp(i), stamp(i + 5), random_pose(generator)});
  }
  const Pose2 T_other_map = random_pose(generator);
  Trajectory moved(trajectory.rbegin(), trajectory.rend());
  for (StampedPose& stamped : moved) stamped.pose = T_other_map * stamped.pose;
  const RelationErrors before = relation_error(trajectory, relations).all;
  const RelationErrors after = relation_error(moved, relations).all;
  EXPECT_NEAR(before.translation_m.mean, after.translation_m.mean, 1e-9);
  EXPECT_NEAR(before.rotation_rad.deviation, after.rotation_rad.deviation, 1e-9);
}

TEST(RelationError, SplitsAtSixtySecondsEitherWayRound) {
  const Trajectory trajectory = {{stamp(0.0), {}}, {stamp(59.9), {}}, {stamp(60.0), {}}};
  const std::vector<Relation> relations = {
      {stamp(0.0), stamp(59.9), {}}, {stamp(60.0), stamp(0.0), {}}, {stamp(0.0), stamp(60.0), {}}};
  const RelationErrorReport report = relation_error(trajectory, relations);
  EXPECT_EQ(report.under_60_s.num_relations, 1U);
  EXPECT_EQ(report.from_60_s.num_relations, 2U);
}

TEST(RelationError, StampsMatchWithinTheirRoundingOnly) {
  const Trajectory trajectory = {{Timestamp{1'000'000'000}, {}},
                                 {Timestamp{2'000'000'000}, {1.0, 0.0, 0.0}},
                                 {Timestamp{2'000'009'000}, {5.0, 0.0, 0.0}}};
  const std::vector<Relation> relations = {
      {Timestamp{1'000'010'000}, Timestamp{2'000'003'000}, {1.0, 0.0, 0.0}},  // nearest: the 2nd
      {Timestamp{1'000'020'000}, Timestamp{2'000'000'000}, {1.0, 0.0, 0.0}},  // 20 us away
  };
  const RelationErrorReport report = relation_error(trajectory, relations);
  EXPECT_EQ(report.all.num_relations, 1U);
  EXPECT_EQ(report.num_missing, 1U);
  EXPECT_EQ(report.all.translation_m.mean, 0.0);
}

TEST(RelationError, NothingInNothingOut) {
  const RelationErrorReport report = relation_error({}, {});
  EXPECT_EQ(report.all.num_relations, 0U);
  EXPECT_EQ(report.all.translation_m.mean, 0.0);
}

}  // namespace setsquare::relation_error_test
