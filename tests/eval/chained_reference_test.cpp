// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Relations with noise around a way of many rounds, the map's drift along it, and closures between
// scans that no relation knows.
#include "setsquare/eval/chained_reference.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "setsquare/eval/closure_judgement.hpp"
#include "setsquare/eval/relation_error.hpp"
#include "tests/eval/random_trajectory.hpp"
#include "tests/support/pose_matchers.hpp"

namespace setsquare::chained_reference_test {

using testing::PoseNear;
using testing::PoseTolerance;
using testing::small_motion;
using testing::stamp_at;

constexpr int kScansARound = 400;
constexpr double kSecondsAScan = 0.25;

/// Rounds of a circle of 32 m: 0.08 m per scan.
Trajectory rounds(int num_rounds) {
  Trajectory truth;
  const double radius_m = 32.0 / kTwoPi;
  for (int k = 0; k < num_rounds * kScansARound; ++k) {
    const double angle_rad = kTwoPi * k / kScansARound;
    truth.push_back({stamp_at(kSecondsAScan * k),
                     {radius_m * std::cos(angle_rad),
                      radius_m * std::sin(angle_rad),
                      wrap_to_pi(angle_rad + kPi / 2)}});
  }
  return truth;
}

/// The same with a drift of 1 mm per scan: right to a centimetre over a second, wrong over a round.
Trajectory drifting(const Trajectory& truth) {
  Trajectory map = truth;
  Pose2 T_drift;
  for (StampedPose& stamped : map) {
    T_drift = T_drift * Pose2{0.001, 0.0, 0.0002};
    stamped.pose = T_drift * stamped.pose;
  }
  return map;
}

Relation relation_of(const Trajectory& truth,
                     std::size_t a,
                     std::size_t b,
                     std::mt19937_64& noise) {
  return {truth[a].stamp,
          truth[b].stamp,
          truth[a].pose.inverse() * truth[b].pose * small_motion(noise, 0.02, 0.004)};
}

/// Each fifth scan to the next, and every second of those to the one a round later.
std::vector<Relation> relations_of(const Trajectory& truth, std::mt19937_64& noise) {
  std::vector<Relation> relations;
  for (std::size_t k = 0; k + 5 < truth.size(); k += 5) {
    relations.push_back(relation_of(truth, k, k + 5, noise));
    if (k % 10 == 0 && k + kScansARound < truth.size()) {
      relations.push_back(relation_of(truth, k, k + kScansARound, noise));
    }
  }
  return relations;
}

std::vector<LoopClosure> closures_of(const Trajectory& truth) {
  std::vector<LoopClosure> closures;
  for (std::size_t i = 3; i + kScansARound + 4 < truth.size(); i += 7) {
    const std::size_t j = i + kScansARound + i % 5;
    closures.push_back({truth[i].stamp,
                        truth[j].stamp,
                        truth[i].pose.inverse() * truth[j].pose,
                        ClosureAxes::kXY,
                        true,
                        1.0,
                        ""});
  }
  return closures;
}

ReferencePoses expected_of(const ChainedReference& reference) {
  return [&reference](Timestamp i, Timestamp j) { return reference.expected(i, j); };
}

TEST(ChainedReference, FindsThePlantedWrongClosuresAndNoOthers) {
  auto generator = testing::make_generator();
  const Trajectory truth = rounds(3);
  const Trajectory map = drifting(truth);
  const ChainedReference reference(relations_of(truth, generator), map);
  std::vector<LoopClosure> closures = closures_of(truth);
  std::vector<bool> is_planted(closures.size(), false);
  for (std::size_t k = 4; k < closures.size(); k += 9) {
    is_planted[k] = true;
    Pose2& T_i_j = closures[k].T_i_j;
    T_i_j = k % 2 == 0 ? T_i_j * Pose2{0.7, 0.0, 0.0} : T_i_j * Pose2{0.0, 0.0, 0.2};
  }
  const auto judgements = judge_closures(closures, expected_of(reference), PoseIndex(map));
  std::size_t num_judged = 0;
  for (std::size_t k = 0; k < closures.size(); ++k) {
    if (judgements[k].verdict == ClosureTruth::kUnjudged) continue;
    if (judgements[k].verdict == ClosureTruth::kBorderline) continue;
    ++num_judged;
    EXPECT_EQ(judgements[k].verdict, is_planted[k] ? ClosureTruth::kWrong : ClosureTruth::kRight)
        << k;
  }
  EXPECT_GT(num_judged, closures.size() * 9 / 10);
}

// The map is off by far more than the limits between the rounds: only the hops may come from it.
TEST(ChainedReference, TheDriftOfTheTrajectoryDoesNotEnter) {
  auto generator = testing::make_generator();
  const Trajectory truth = rounds(2);
  const Trajectory map = drifting(truth);
  EXPECT_GT(relation_error(map, relations_of(truth, generator)).from_60_s.translation_m.mean, 0.3);
  std::vector<Relation> exact;
  for (std::size_t k = 0; k + kScansARound < truth.size(); k += 8) {
    exact.push_back({truth[k].stamp,
                     truth[k + kScansARound].stamp,
                     truth[k].pose.inverse() * truth[k + kScansARound].pose});
  }
  const ChainedReference reference(exact, map);
  for (const LoopClosure& closure : closures_of(truth)) {
    const auto poses = reference.expected(closure.stamp_i, closure.stamp_j);
    ASSERT_FALSE(poses.empty());
    EXPECT_THAT(
        poses.front().T_i_j,
        PoseNear(closure.T_i_j, PoseTolerance{.translation_m = 0.03, .rotation_rad = 0.01}));
  }
}

TEST(ChainedReference, HopsAreShortInTimeInDistanceAndInRotation) {
  const std::vector<Relation> relations = {{stamp_at(10), stamp_at(100), {1, 0, 0}}};
  const auto is_told = [&relations](double seconds, const Pose2& T_node_scan) {
    const Trajectory map = {{stamp_at(10), {5, 5, 1}},
                            {stamp_at(10 + seconds), Pose2{5, 5, 1} * T_node_scan},
                            {stamp_at(100), {6, 5, 1}}};
    const auto poses =
        ChainedReference(relations, map).expected(stamp_at(10 + seconds), stamp_at(100));
    if (poses.empty()) return false;
    EXPECT_THAT(poses.front().T_i_j,
                PoseNear(T_node_scan.inverse() * Pose2{1, 0, 0}, PoseTolerance{}));
    return true;
  };
  EXPECT_TRUE(is_told(4.9, {1.9, 0.0, 0.5}));
  EXPECT_TRUE(is_told(-4.9, {0.0, -1.9, -0.5}));
  EXPECT_FALSE(is_told(5.1, {1.9, 0.0, 0.5}));
  EXPECT_FALSE(is_told(4.9, {2.1, 0.0, 0.5}));
  EXPECT_FALSE(is_told(4.9, {1.9, 0.0, 0.6}));
}

TEST(ChainedReference, AScanThatTheTrajectoryDoesNotHaveHasNoPose) {
  auto generator = testing::make_generator();
  const Trajectory truth = rounds(2);
  const ChainedReference reference(relations_of(truth, generator), truth);
  EXPECT_FALSE(reference.expected(truth[5].stamp, truth[405].stamp).empty());
  EXPECT_TRUE(reference.expected(stamp_at(-3), truth[405].stamp).empty());
  EXPECT_TRUE(reference.expected(truth[6].stamp, truth[7].stamp).empty()) << "no relation between";
}

TEST(ChainCheck, FindsNoFaultInGoodRelationsAndThePlantedBadOne) {
  auto generator = testing::make_generator();
  const Trajectory truth = rounds(3);
  std::vector<Relation> relations = relations_of(truth, generator);
  const ChainCheck good = check_chains(relations);
  EXPECT_EQ(good.verdicts.num_closures, 80U);
  EXPECT_GT(good.verdicts.num_right, 70U);
  EXPECT_EQ(good.verdicts.num_wrong, 0U);
  EXPECT_EQ(good.verdicts.num_disputed, 0U);
  EXPECT_EQ(good.translation_m.num_values, 80U - good.verdicts.num_unjudged);
  EXPECT_GT(good.translation_m.mean, 0.02);
  EXPECT_LT(good.translation_m.max, 0.3);
  for (Relation& relation : relations) {
    if (relation.current_stamp == truth[40 + kScansARound].stamp &&
        relation.reference_stamp == truth[40].stamp) {
      relation.T_reference_current.x_m += 1.0;
    }
  }
  const ChainCheck bad = check_chains(relations);
  EXPECT_GE(bad.verdicts.num_wrong, 1U) << "itself";
  EXPECT_GT(bad.translation_m.max, 0.8);
}

}  // namespace setsquare::chained_reference_test
