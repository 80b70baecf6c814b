// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/live_localizer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <random>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/grid/grid_from_scans.hpp"
#include "tests/support/seed.hpp"
#include "tests/support/simulated_drive.hpp"

namespace setsquare::live_localizer_test {

constexpr testing::Fan kFan{541, -0.75 * kPi, rad_from_deg(0.5)};
constexpr double kNoise_m = 0.01;

/// A room that was mapped at the true poses, and another way through it.
class LiveLocalizerInARoom : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto mapping = testing::drive(testing::way_around_the_room());
    const auto seen = testing::scans_on_drive(testing::l_shaped_room(), mapping, kNoise_m, kFan);
    std::vector<PlacedScan> placed;
    for (std::size_t i = 0; i < seen.size(); ++i) placed.push_back({&seen[i], mapping[i]});
    map_ = std::make_shared<const KnownMap>(grid_from_scans(placed));
    truth_ = testing::drive({{4.0, 3.0}, {2.0, 2.0}, {1.5, 7.0}, {3.0, 3.0}});
    scans_ = testing::scans_on_drive(testing::l_shaped_room(), truth_, kNoise_m, kFan);
  }

  std::shared_ptr<const KnownMap> map_;
  std::vector<Pose2> truth_;
  std::vector<Scan> scans_;
};

void expect_same(const LocalisedPose& a, const LocalisedPose& b) {
  EXPECT_EQ(a.stamp, b.stamp);
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.T_map_base, b.T_map_base);
  EXPECT_EQ(a.probability, b.probability);
  EXPECT_EQ(a.covariance, b.covariance);
  EXPECT_EQ(a.alternatives.size(), b.alternatives.size());
}

// The twin: Localizer, on one thread.
TEST_F(LiveLocalizerInARoom, PlacesEachScanAsLocalizerDoes) {
  SCOPED_TRACE(testing::test_seed());
  std::mt19937_64 random = testing::make_generator();
  std::vector<LocalisedPose> places;
  LiveLocalizer live(map_, {}, [&](const LocalisedPose& place) { places.push_back(place); });
  Localizer localizer(map_);
  std::vector<LocalisedPose> expected;
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    if (i == 20) {
      live.set_pose(truth_[i]);
      localizer.set_pose(truth_[i]);
    }
    (void)live.add(scans_[i]);
    expected.push_back(localizer.add(scans_[i]));
    if (random() % 30 == 0) live.finish();
  }
  live.finish();
  EXPECT_EQ(live.num_behind(), 0U);
  ASSERT_EQ(places.size(), expected.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    SCOPED_TRACE(i);
    expect_same(places[i], expected[i]);
  }
}

TEST_F(LiveLocalizerInARoom, NoPoseIsToldBeforeThePlaceIsKnownAndThenEachIsRight) {
  LiveLocalizer live(map_, {}, {});
  EXPECT_FALSE(live.add(scans_[0]).is_placed);
  std::size_t num_placed = 0;
  for (std::size_t i = 1; i < scans_.size(); ++i) {
    live.finish();  // What the other thread knows is that of the scan before.
    const LivePose pose = live.add(scans_[i]);
    ASSERT_TRUE(pose.localisation.has_value());
    EXPECT_EQ(pose.is_placed, *pose.localisation == LocalisationStatus::kLocalised);
    if (!pose.is_placed) continue;
    ++num_placed;
    EXPECT_LT((pose.T_map_base.translation() - truth_[i].translation()).norm(), 0.08) << i;
    const Pose2 by_frames = pose.T_map_odom * pose.T_odom_base;
    EXPECT_NEAR((pose.T_map_base.translation() - by_frames.translation()).norm(), 0.0, 1e-9);
    EXPECT_GT(pose.covariance(0, 0), 0.0);
  }
  EXPECT_GE(num_placed, scans_.size() * 8 / 10);
}

TEST_F(LiveLocalizerInARoom, WhereTheWheelsTellTheWayTheyAreTheOdometry) {
  LiveLocalizer live(map_, {}, {});
  for (std::size_t i = 0; i < 30; ++i) {
    const LivePose pose = live.add(scans_[i], truth_[i]);
    EXPECT_TRUE(pose.has_wheels);
    EXPECT_EQ(pose.T_odom_base, truth_[i]);
  }
}

// The search stands still, as if it took for ever.
TEST_F(LiveLocalizerInARoom, WhereTheSearchIsTooFarBehindTrackingGoesOn) {
  std::mutex standing;
  std::vector<Timestamp> placed;
  std::optional<LocalisedPose> last;
  LiveLocalizer live(map_,
                     {},
                     [&](const LocalisedPose& place) {
                       const std::lock_guard lock(standing);
                       placed.push_back(place.stamp);
                       last = place;
                     },
                     {.max_scans = 32});
  {
    const std::lock_guard lock(standing);
    for (std::size_t i = 0; i < scans_.size(); ++i) {
      if (i == 20) live.set_pose(truth_[i]);
      (void)live.add(scans_[i]);
    }
    EXPECT_LE(live.num_behind(), 33U);
    EXPECT_GE(live.num_left_out(), scans_.size() - 34);
  }
  live.finish();
  EXPECT_EQ(placed.size() + live.num_left_out(), scans_.size());
  EXPECT_TRUE(std::is_sorted(placed.begin(), placed.end()));
  ASSERT_TRUE(last.has_value());
  EXPECT_EQ(last->stamp, scans_.back().stamp);
  EXPECT_EQ(last->status, LocalisationStatus::kLocalised);
  EXPECT_LT((last->T_map_base.translation() - truth_.back().translation()).norm(), 0.08);
}

TEST_F(LiveLocalizerInARoom, ALogThatNobodyDrivesLosesNoScan) {
  std::size_t num_placed = 0;
  LiveLocalizer live(
      map_, {}, [&](const LocalisedPose&) { ++num_placed; }, {.max_scans = 2, .waits = true});
  for (const Scan& scan : scans_) (void)live.add(scan);
  live.finish();
  EXPECT_EQ(num_placed, scans_.size());
  EXPECT_EQ(live.num_left_out(), 0U);
}

TEST_F(LiveLocalizerInARoom, APoseThatIsNoneIsRefused) {
  LiveLocalizer live(map_, {}, {});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(live.set_pose({nan, 0.0, 0.0}), ParameterError);
  EXPECT_THROW(live.add(scans_[0], Pose2{0.0, nan, 0.0}), ParameterError);
  (void)live.add(scans_[0]);
  live.finish();
}

TEST_F(LiveLocalizerInARoom, WhatTheListenerThrowsIsTold) {
  LiveLocalizer live(map_, {}, [](const LocalisedPose&) { throw FileError("x", "is full"); });
  (void)live.add(scans_[0]);
  EXPECT_THROW(live.finish(), FileError);
  EXPECT_THROW((void)live.add(scans_[1]), FileError);
}

}  // namespace setsquare::live_localizer_test
