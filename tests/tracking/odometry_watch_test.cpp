// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/odometry_watch.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "setsquare/tracking/repeated_scan.hpp"
#include "tests/support/simulated_drive.hpp"

namespace setsquare::odometry_watch_test {

using testing::drive;
using testing::l_shaped_room;
using testing::scans_on_drive;
using testing::way_around_the_room;

TEST(OdometryWatch, BelievesWheelsThatTurn) {
  const auto truth = drive(way_around_the_room());
  const auto scans = scans_on_drive(l_shaped_room(), truth, 0.01);
  OdometryWatch watch;
  for (std::size_t i = 0; i < scans.size(); ++i)
    EXPECT_EQ(watch.believed(scans[i], truth[i]), truth[i]);
}

TEST(OdometryWatch, BelievesARobotThatStands) {
  const std::vector<Pose2> truth(50, Pose2{2.0, 2.0, 0.5});
  OdometryWatch watch;
  for (const Scan& scan : scans_on_drive(l_shaped_room(), truth, 0.01)) {
    EXPECT_TRUE(watch.believed(scan, truth[0]).has_value());
  }
}

TEST(OdometryWatch, DoesNotGiveACounterThatHungTenScansAgain) {
  const auto truth = drive(way_around_the_room(), 0.5);
  const auto scans = scans_on_drive(l_shaped_room(), truth, 0.01);
  OdometryWatch watch;
  const std::size_t half = scans.size() / 2;
  for (std::size_t i = 0; i < half; ++i) (void)watch.believed(scans[i], Pose2{});
  std::size_t num_believed = 0;
  for (std::size_t i = half; i < scans.size(); ++i) {
    num_believed += watch.believed(scans[i], Pose2{5.0, 0.0, 0.0}).has_value();
  }
  EXPECT_LT(num_believed, 10U) << "of " << scans.size() - half;
}

TEST(OdometryWatch, DoesNotBelieveAPoseThatStandsWhileTheScansMove) {
  const auto scans = scans_on_drive(l_shaped_room(), drive(way_around_the_room()), 0.01);
  OdometryWatch watch;
  std::size_t num_believed = 0;
  for (const Scan& scan : scans) num_believed += watch.believed(scan, Pose2{}).has_value();
  EXPECT_LT(num_believed, 40U);
  EXPECT_TRUE(watch.believed(scans.back(), Pose2{0.1, 0.0, 0.0}).has_value()) << "it moves again";
}

TEST(OdometryWatch, DoesNotBelieveAPoseOnAnotherPlanet) {
  OdometryWatch watch;
  EXPECT_FALSE(watch.believed(Scan{}, Pose2{5.9e22, 0.0, 0.0}).has_value());
  EXPECT_TRUE(watch.believed(Scan{}, Pose2{5.9e5, -4e6, 0.0}).has_value()) << "a national grid";
  EXPECT_FALSE(watch.believed(Scan{}, std::nullopt).has_value());
}

TEST(RepeatedScan, IsOneOnlyWhileTheWheelsMove) {
  Scan scan;
  scan.ranges_m = {1.0, 2.0, 3.0};
  RepeatedScan repeated;
  EXPECT_FALSE(repeated.add(scan, Pose2{}));
  EXPECT_FALSE(repeated.add(scan, Pose2{})) << "the robot may stand";
  EXPECT_TRUE(repeated.add(scan, Pose2{0.05, 0.0, 0.0}));
  EXPECT_TRUE(repeated.add(scan, Pose2{0.05, 0.0, 0.01}));
  EXPECT_TRUE(repeated.add(scan, Pose2{0.05, 0.0, 0.01})) << "it hangs, though the wheels rest";
  scan.ranges_m[1] = 2.001;
  EXPECT_FALSE(repeated.add(scan, Pose2{0.2, 0.0, 0.0}));
  EXPECT_FALSE(repeated.add(scan, std::nullopt)) << "nobody knows";
  EXPECT_TRUE(repeated.is_same());
}

// Drivers that send nothing for a beam leave NaN, which is not equal to itself.
TEST(RepeatedScan, IsOneThoughARangeIsMissing) {
  Scan scan;
  scan.ranges_m = {1.0, std::numeric_limits<double>::quiet_NaN(), 2.0};
  RepeatedScan repeated;
  (void)repeated.add(scan, std::nullopt);
  (void)repeated.add(scan, std::nullopt);
  EXPECT_TRUE(repeated.is_same());
  scan.ranges_m[1] = 1.5;
  (void)repeated.add(scan, std::nullopt);
  EXPECT_FALSE(repeated.is_same());
}

}  // namespace setsquare::odometry_watch_test
