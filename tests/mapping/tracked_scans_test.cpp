// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Against a plain list of the same scans.
#include "setsquare/mapping/tracked_scans.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/support/seed.hpp"

namespace setsquare::tracked_scans_test {

using testing::uniform;

class TrackedScansAgainstAList : public ::testing::Test {
 protected:
  Pose2 random_pose() {
    return {uniform(random_, -9.0, 9.0), uniform(random_, -9.0, 9.0), uniform(random_, -kPi, kPi)};
  }

  TrackedScan random_scan() {
    TrackedScan scan{.stamp = {static_cast<std::int64_t>(random_())},
                     .status = static_cast<TrackStatus>(random_() % 4),
                     .has_odometry = random_() % 2 == 0,
                     .is_restart = random_() % 2 == 0,
                     .is_same_again = random_() % 2 == 0,
                     .score = static_cast<float>(uniform(random_, -1.0, 1.0)),
                     .T_odom_sensor = random_pose(),
                     .T_base_sensor = mountings_[random_() % mountings_.size()],
                     .open = {}};
    if (random_() % 4 > 0) return scan;
    scan.open = {.direction = {uniform(random_, -1.0, 1.0), uniform(random_, -1.0, 1.0)},
                 .sigma_m = uniform(random_, 0.0, 1.0),
                 .is_turn_open = random_() % 2 == 0,
                 .turn_sigma_rad = uniform(random_, 0.0, 1.0),
                 .turn_motion_m = {uniform(random_, -1.0, 1.0), uniform(random_, -1.0, 1.0)}};
    return scan;
  }

  void change_at_random() {
    const std::size_t n = list_.size();
    switch (random_() % 8) {
      case 0: {
        if (n == 0) return;
        const std::size_t first = random_() % n;
        const std::size_t end = first + random_() % std::min<std::size_t>(n - first + 1, 9);
        scans_.erase(first, end);
        list_.erase(list_.begin() + static_cast<std::ptrdiff_t>(first),
                    list_.begin() + static_cast<std::ptrdiff_t>(end));
        return;
      }
      case 1: {
        const std::size_t num = n - std::min<std::size_t>(n, random_() % 3);
        scans_.resize(num);
        list_.resize(num);
        return;
      }
      case 2: {
        if (n == 0) return;
        const std::size_t moved = random_() % n;
        const Pose2 pose = random_pose();
        scans_.move_to_odom(moved, pose);
        move_to_odom(pose, list_[moved]);
        return;
      }
      default:
        list_.push_back(random_scan());
        scans_.add(list_.back());
    }
  }

  void expect_same() const {
    ASSERT_EQ(scans_.size(), list_.size());
    for (std::size_t i = 0; i < list_.size(); ++i) {
      const TrackedScan scan = scans_[i];
      const TrackedScan& listed = list_[i];
      ASSERT_EQ(scan.stamp, listed.stamp) << i;
      ASSERT_EQ(scan.status, listed.status) << i;
      ASSERT_EQ(scan.has_odometry, listed.has_odometry) << i;
      ASSERT_EQ(scan.is_restart, listed.is_restart) << i;
      ASSERT_EQ(scan.is_same_again, listed.is_same_again) << i;
      ASSERT_EQ(scan.score, listed.score) << i;
      ASSERT_EQ(scan.T_odom_sensor, listed.T_odom_sensor) << i;
      ASSERT_EQ(scan.T_base_sensor, listed.T_base_sensor) << i;
      ASSERT_EQ(scan.open.direction, listed.open.direction) << i;
      ASSERT_EQ(scan.open.sigma_m, listed.open.sigma_m) << i;
      ASSERT_EQ(scan.open.is_turn_open, listed.open.is_turn_open) << i;
      ASSERT_EQ(scan.open.turn_sigma_rad, listed.open.turn_sigma_rad) << i;
      ASSERT_EQ(scan.open.turn_motion_m, listed.open.turn_motion_m) << i;
      ASSERT_EQ(scans_.stamp(i), listed.stamp) << i;
      ASSERT_EQ(scans_.T_odom_sensor(i), listed.T_odom_sensor) << i;
      ASSERT_EQ(scans_.is_same_again(i), listed.is_same_again) << i;
    }
  }

  std::mt19937_64 random_ = testing::make_generator();
  /// More than are searched for one that is the same.
  std::vector<Pose2> mountings_ = std::vector<Pose2>(40);
  std::vector<TrackedScan> list_;
  TrackedScans scans_;
};

TEST_F(TrackedScansAgainstAList, HoldTheSameWhateverIsDoneToThem) {
  SCOPED_TRACE(testing::test_seed());
  for (Pose2& mounting : mountings_) mounting = random_pose();
  for (int step = 0; step < 600; ++step) {
    change_at_random();
    expect_same();
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(scans_.size(), 20U);
}

TEST_F(TrackedScansAgainstAList, AMountingThatDiffersByRoundingIsTheSame) {
  TrackedScan scan = random_scan();
  scan.T_base_sensor = {0.1, 0.2, 0.3};
  scans_.add(scan);
  scan.T_base_sensor.x_m += 1e-15;
  scans_.add(scan);
  scan.T_base_sensor.x_m += 1e-9;
  scans_.add(scan);
  EXPECT_EQ(scans_[1].T_base_sensor, scans_[0].T_base_sensor);
  EXPECT_NE(scans_[2].T_base_sensor, scans_[0].T_base_sensor);
}

}  // namespace setsquare::tracked_scans_test
