// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Memory that the building bounds, not the time: a robot that patrols.
#include "setsquare/mapping/forgetting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <vector>

#include "setsquare/map/map_summary.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "tests/mapping/tracked_world.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::forgetting_test {

using testing::PoseNear;
using testing::PoseTolerance;
using testing::Wall;

constexpr double kNoise_m = 0.01;
const PoseTolerance kRounding{.translation_m = 1e-9, .rotation_rad = 1e-9};
const PoseTolerance kTrue{.translation_m = 0.05, .rotation_rad = rad_from_deg(0.5)};

/// A robot that goes around the block.
struct Patrol {
  explicit Patrol(int num_rounds) {
    std::vector<Eigen::Vector2d> way;
    for (int round = 0; round < num_rounds; ++round) {
      way.insert(way.end(), {{1.0, 1.0}, {15.0, 1.0}, {15.0, 11.0}, {1.0, 11.0}});
    }
    way.emplace_back(1.0, 1.0);
    truth = testing::drive(way, 0.15, rad_from_deg(6.0));
  }
  std::vector<Pose2> truth;

  /// `changes_at`: from this share of the way on the walls are `later`.
  [[nodiscard]] Map mapped(const ForgettingParams& forgetting) const {
    return mapped(true, testing::corridor_around_a_block(), 1.0, forgetting);
  }
  [[nodiscard]] Map mapped(bool forgets,
                           const std::vector<Wall>& later = testing::corridor_around_a_block(),
                           double changes_at = 1.0,
                           const ForgettingParams& forgetting = {}) const {
    MapperParams params;
    params.forgetting = forgetting;
    params.forgetting.is_on = forgets;
    params.audit.is_on = false;
    Mapper mapper(params);
    const std::vector<Wall> walls = testing::corridor_around_a_block();
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const bool is_later =
          static_cast<double>(i) >= changes_at * static_cast<double>(truth.size());
      Scan scan = testing::scan_of_walls(
          is_later ? later : walls, truth[i], testing::kAllAround, kNoise_m, i + 1);
      scan.stamp.ns = static_cast<std::int64_t>(i) * 100'000'000;
      mapper.add(scan);
    }
    return mapper.finish();
  }

  /// Root mean square of the positions' errors; poses are those seen from the first.
  [[nodiscard]] double error_m(const Map& map) const {
    double sum_m2 = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const Pose2 true_pose = truth.front().inverse() * truth[i];
      const Pose2 pose = map.scans.front().T_map_base.inverse() * map.scans[i].T_map_base;
      sum_m2 += (pose.translation() - true_pose.translation()).squaredNorm();
    }
    return std::sqrt(sum_m2 / static_cast<double>(truth.size()));
  }
};

TEST(Forgetting, APatrolKeepsNoMoreThanItsFirstRoundsLeft) {
  const Map of_6 = Patrol(6).mapped(true);
  const Map of_12 = Patrol(12).mapped(true);
  EXPECT_GT(of_12.num_forgotten, of_6.num_forgotten + 400);
  // Loops are closed, and keyframes forgotten, each time that the track has grown by a tenth.
  const auto a_closing = of_6.keyframes.size() / 5;
  EXPECT_LT(of_12.keyframes.size(), of_6.keyframes.size() + a_closing);
  EXPECT_LT(of_12.kept_scans.size(), of_6.kept_scans.size() + 4 * a_closing);
  EXPECT_LT(of_12.closures.size(), of_6.closures.size() + 4 * a_closing);
  EXPECT_EQ(of_12.scans.size(), Patrol(12).truth.size()) << "every scan has its pose";
  validate(of_12);
}

TEST(Forgetting, SwitchedOffThePatrolsMapGrows) {
  const Map of_6 = Patrol(6).mapped(false);
  const Map of_12 = Patrol(12).mapped(false);
  EXPECT_EQ(of_12.num_forgotten, 0U);
  EXPECT_GT(of_12.keyframes.size(), 2 * of_6.keyframes.size() - 10);
}

TEST(Forgetting, TheMapIsNoWorse) {
  const Patrol patrol(10);
  const Map kept = patrol.mapped(false);
  const Map forgotten = patrol.mapped(true);
  ASSERT_GT(forgotten.num_forgotten, 0U);
  EXPECT_LT(patrol.error_m(forgotten), patrol.error_m(kept) + 0.005);
  const Pose2 true_end = patrol.truth.front().inverse() * patrol.truth.back();
  EXPECT_THAT(forgotten.scans.front().T_map_base.inverse() * forgotten.scans.back().T_map_base,
              PoseNear(true_end, kTrue));
}

/// The scans of `few` are those of `all` but for the ones left out, and lie as they do there.
void expect_left_as_they_were(const Map& few, const Map& all) {
  std::size_t of_all = 0;
  std::size_t gap = 0;
  for (std::size_t i = 0; i < few.scans.size(); ++i, ++of_all) {
    if (gap < few.forgotten_poses.size() && few.forgotten_poses[gap].next_scan == i) {
      const std::size_t num = few.forgotten_poses[gap].num_scans;
      double way_m = 0.0;
      for (std::size_t k = of_all; k <= of_all + num; ++k) {
        way_m += (all.scans[k].T_map_base.translation() - all.scans[k - 1].T_map_base.translation())
                     .norm();
      }
      EXPECT_NEAR(few.forgotten_poses[gap].way_m, way_m, 0.02 * way_m);
      of_all += num;
      ++gap;
    }
    ASSERT_EQ(few.scans[i].stamp, all.scans[of_all].stamp) << i;
    ASSERT_THAT(few.scans[i].T_map_base, PoseNear(all.scans[of_all].T_map_base, kRounding)) << i;
  }
  EXPECT_EQ(of_all, all.scans.size());
}

TEST(Forgetting, PosesOfKnownGroundAreBoundedAndTheOthersLieAsBefore) {
  const Patrol patrol(12);
  const Map all = patrol.mapped(true);
  ForgettingParams forgetting;
  forgetting.max_known_poses = 300;
  const Map few = patrol.mapped(forgetting);
  validate(few);
  ASSERT_FALSE(few.forgotten_poses.empty());
  EXPECT_LT(few.forgotten_poses.size(), 20U);
  expect_left_as_they_were(few, all);
  EXPECT_EQ(few.num_forgotten, all.num_forgotten);
  EXPECT_EQ(few.keyframes.size(), all.keyframes.size());
  EXPECT_EQ(few.closures.size(), all.closures.size());
  EXPECT_NEAR(summary_of(few).path_m, summary_of(all).path_m, 0.02 * summary_of(all).path_m);
  EXPECT_EQ(occupancy_grid(few).values(), occupancy_grid(all).values());
}

TEST(Forgetting, WithPosesBoundedTheNumberOfScansStays) {
  ForgettingParams forgetting;
  forgetting.max_known_poses = 300;
  const Map of_8 = Patrol(8).mapped(forgetting);
  const Map of_16 = Patrol(16).mapped(forgetting);
  const std::size_t num_driven = Patrol(16).truth.size() - Patrol(8).truth.size();
  // What came since keyframes were last forgotten has its poses.
  EXPECT_LT(of_16.scans.size(), of_8.scans.size() + num_driven / 4);
  EXPECT_EQ(of_16.scans.size() + summary_of(of_16).num_forgotten_poses, Patrol(16).truth.size());
}

TEST(Forgetting, AMapWithoutSomePosesIsGoneOnWith) {
  ForgettingParams forgetting;
  forgetting.max_known_poses = 300;
  const Map few = Patrol(10).mapped(forgetting);
  ASSERT_FALSE(few.forgotten_poses.empty());
  MapperParams params;
  params.audit.is_on = false;
  const Map again = Mapper(few, params).finish();
  EXPECT_EQ(summary_of(again).num_forgotten_poses, summary_of(few).num_forgotten_poses);
  EXPECT_EQ(again.keyframes, few.keyframes);
  ASSERT_EQ(again.scans.size(), few.scans.size());
}

TEST(Forgetting, WhatIsDrivenFewTimesIsKept) {
  const Patrol patrol(3);
  const Map kept = patrol.mapped(false);
  const Map map = patrol.mapped(true);
  EXPECT_EQ(map.num_forgotten, 0U);
  ASSERT_EQ(map.scans.size(), kept.scans.size());
  for (std::size_t i = 0; i < map.scans.size(); ++i) {
    ASSERT_EQ(map.scans[i].T_map_base, kept.scans[i].T_map_base) << "scan " << i;
  }
}

TEST(Forgetting, KeepsWhatShowsThatWallsChanged) {
  const Patrol patrol(10);
  std::vector<Wall> later = testing::corridor_around_a_block();
  later.push_back({8.0, 12.0, 8.0, 11.3});  // A cabinet.
  later.push_back({8.0, 11.3, 6.5, 11.3});
  later.push_back({6.5, 11.3, 6.5, 12.0});
  const Map map = patrol.mapped(true, later, 0.7);
  ASSERT_GT(map.num_forgotten, 0U);
  const auto is_beside_it = [&](std::size_t scan) {
    return scan >= patrol.truth.size() * 7 / 10 && std::abs(patrol.truth[scan].x_m - 7.25) < 2.0 &&
           patrol.truth[scan].y_m > 10.0;
  };
  EXPECT_TRUE(std::ranges::any_of(map.keyframes, is_beside_it));
}

TEST(Forgetting, AMapThatIsGoneOnWithByNothingStaysAsItIs) {
  const Map grown = Patrol(7).mapped(false);
  MapperParams params;
  params.audit.is_on = false;
  const Map again = Mapper(grown, params).finish();
  EXPECT_EQ(again.num_forgotten, 0U);
  EXPECT_EQ(again.keyframes, grown.keyframes);
  const Map patrolled = Patrol(7).mapped(true);
  ASSERT_GT(patrolled.num_forgotten, 0U);
  const Map patrolled_again = Mapper(patrolled, params).finish();
  EXPECT_EQ(patrolled_again.num_forgotten, patrolled.num_forgotten);
  EXPECT_EQ(patrolled_again.keyframes, patrolled.keyframes);
}

// --- The rule, without scans ---------------------------------------------------------------------

/// Keyframes at these poses, a scan between each two.
struct Parts {
  explicit Parts(const std::vector<Pose2>& T_odom_sensor) {
    for (std::size_t k = 0; k < T_odom_sensor.size(); ++k) {
      Keyframe keyframe;
      keyframe.scan_index = 2 * k;
      keyframe.T_odom_sensor = T_odom_sensor[k];
      keyframe.T_odom_body = T_odom_sensor[k];
      keyframe.scan = std::make_shared<const Scan>();
      track.keyframes.push_back(std::make_shared<const Keyframe>(keyframe));
      track.motions.push_back(testing::small_covariance());
      track.stretches.push_back(0);
      track.pieces.push_back(0);
      shares_of_place.push_back(1.0);
      evidence.emplace_back().tracked_heading_rad = T_odom_sensor[k].theta_rad;
      for (const Pose2& pose : {T_odom_sensor[k], T_odom_sensor[k] * Pose2{0.1, 0.0, 0.05}}) {
        TrackedScan scan;
        scan.T_odom_sensor = pose;
        scans.add(scan);
        kept_scans.push_back({scans.size() - 1, keyframe.scan});
      }
    }
  }
  TrackedParts parts() { return {scans, kept_scans, track, shares_of_place, evidence}; }

  TrackedScans scans;
  std::vector<KeptScan> kept_scans;
  KeyframeTrack track;
  std::vector<double> shares_of_place;
  std::vector<HeadingEvidence> evidence;
};

Pose2 random_pose(std::mt19937_64& generator) {
  return {testing::uniform(generator, -5.0, 5.0),
          testing::uniform(generator, -5.0, 5.0),
          testing::uniform(generator, -kPi, kPi)};
}

std::vector<Pose2> random_poses(std::size_t num, std::mt19937_64& generator) {
  std::vector<Pose2> poses;
  while (poses.size() < num) poses.push_back(random_pose(generator));
  return poses;
}

TEST(ForgetKeyframes, WithoutDriftNothingMoves) {
  auto generator = testing::make_generator();
  const std::vector<Pose2> tracked = random_poses(12, generator);
  const Pose2 T_map_odom = random_pose(generator);
  std::vector<Pose2> T_map_sensor;
  for (const Pose2& pose : tracked) T_map_sensor.push_back(T_map_odom * pose);
  Parts parts(tracked);
  const TrackedScans before = parts.scans;
  const std::vector<std::size_t> kept{0, 1, 2, 6, 7, 10, 11};
  const Pose2 T_new_old = forget_keyframes(kept, T_map_sensor, {}, parts.parts());
  EXPECT_THAT(T_new_old, PoseNear(Pose2{}, kRounding));
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_THAT(parts.scans.T_odom_sensor(i), PoseNear(before.T_odom_sensor(i), kRounding));
  }
}

TEST(ForgetKeyframes, OverARunTheTrackIsTheMaps) {
  auto generator = testing::make_generator();
  const std::vector<Pose2> tracked = random_poses(12, generator);
  const std::vector<Pose2> T_map_sensor = random_poses(12, generator);
  Parts parts(tracked);
  const std::vector<std::size_t> kept{0, 1, 2, 6, 7, 10, 11};
  const Pose2 T_new_old = forget_keyframes(kept, T_map_sensor, {}, parts.parts());
  const auto& keyframes = parts.track.keyframes;
  ASSERT_EQ(keyframes.size(), kept.size());
  for (std::size_t i = 1; i < kept.size(); ++i) {
    EXPECT_EQ(keyframes[i]->scan_index, 2 * kept[i]);
    EXPECT_THAT(keyframes[i]->T_odom_sensor,
                PoseNear(parts.scans.T_odom_sensor(2 * kept[i]), kRounding));
    const Pose2 moved = keyframes[i - 1]->T_odom_sensor.inverse() * keyframes[i]->T_odom_sensor;
    const bool is_joined = kept[i] != kept[i - 1] + 1;
    const std::size_t run = kept[i - 1] + 1;  // Its first keyframe, where there is one.
    const Pose2 over_it = T_map_sensor[run].inverse() * T_map_sensor[kept[i]];
    const Pose2 told =
        tracked[kept[i - 1]].inverse() * tracked[run] * (is_joined ? over_it : Pose2{});
    EXPECT_THAT(moved, PoseNear(told, kRounding)) << i;
    EXPECT_EQ(parts.track.stretches[i] != parts.track.stretches[i - 1], is_joined);
  }
  for (std::size_t k = 3; k <= 6; ++k) {
    const Pose2 seen = parts.scans.T_odom_sensor(6).inverse() * parts.scans.T_odom_sensor(2 * k);
    EXPECT_THAT(seen, PoseNear(T_map_sensor[3].inverse() * T_map_sensor[k], kRounding)) << k;
  }
  EXPECT_THAT(keyframes.back()->T_odom_sensor, PoseNear(T_new_old * tracked.back(), kRounding));
  EXPECT_THAT(parts.scans.T_odom_sensor(parts.scans.size() - 1),
              PoseNear(T_new_old * tracked.back() * Pose2{0.1, 0.0, 0.05}, kRounding));
  for (const KeptScan& scan : parts.kept_scans) {
    EXPECT_FALSE(scan.index > 4 && scan.index < 12) << "lies in a run";
    EXPECT_FALSE(scan.index > 14 && scan.index < 20) << "lies in a run";
  }
  EXPECT_EQ(parts.kept_scans.size(), 24U - 7U - 5U);
}

/// What of keyframes 0 to `num` - 1 stays where those of `known` show nothing new, and closures tie
/// `held` to keyframe 0.
std::vector<std::size_t> kept_of(std::size_t num,
                                 std::size_t first_known,
                                 std::size_t end_known,
                                 const std::vector<std::size_t>& held) {
  const Parts parts(std::vector<Pose2>(num, Pose2{}));
  std::vector<std::optional<KnownPlace>> places(num);
  for (std::size_t k = first_known; k < end_known; ++k) places[k] = KnownPlace{};
  std::vector<Constraint> closures;
  for (const std::size_t k : held) {
    Constraint& closure = closures.emplace_back();
    closure.from = 0;
    closure.to = k;
  }
  return keyframes_to_keep(parts.track, places, closures, {});
}

TEST(KeyframesToKeep, ARunEndsWhereAClosureHoldsTheTrack) {
  // New: up to 9, and from 40 on; three on either side of what is new stay.
  std::vector<std::size_t> kept(40 + 10);
  std::iota(kept.begin(), kept.end(), 0);
  kept.erase(kept.begin() + 13, kept.begin() + 33);
  EXPECT_EQ(kept_of(50, 10, 40, {20, 33, 38}), kept);
}

TEST(KeyframesToKeep, NothingIsForgottenWithoutAClosureOrInShortRuns) {
  EXPECT_EQ(kept_of(50, 10, 40, {}).size(), 50U);
  EXPECT_EQ(kept_of(50, 10, 40, {8, 45}).size(), 50U);
  EXPECT_EQ(kept_of(50, 10, 24, {20}).size(), 50U);
}

}  // namespace setsquare::forgetting_test
