// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/match/contradictions.hpp"

#include <gtest/gtest.h>

#include "tests/support/rectangular_room.hpp"

namespace setsquare::contradictions_test {

TEST(Contradictions, AreThePointsBeforeTheWalls) {
  const Pose2 T_room_sensor{4.0, 3.0, 0.5};
  const Scan scan = testing::scan_of_room(T_room_sensor, 10.0, 8.0, 720);
  const Pose2 T_sensor_room = T_room_sensor.inverse();
  PointSet points;                 // in the room's frame
  points.push_back(7.0, 5.0, 0);   // in the middle of free space
  points.push_back(10.0, 4.0, 1);  // on the wall
  points.push_back(9.85, 4.0, 2);  // nearly on it
  points.push_back(12.0, 4.0, 3);  // behind it
  const auto found = contradictions(scan, points, T_sensor_room);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR((T_room_sensor * found[0] - Eigen::Vector2d(7.0, 5.0)).norm(), 0.0, 1e-9);
}

TEST(Contradictions, BeamsWithoutInformationContradictNothing) {
  Scan scan = testing::scan_of_room({4.0, 3.0, 0.0}, 10.0, 8.0, 360);
  PointSet points;
  points.push_back(1.0, 0.0, 0);
  points.push_back(-1.0, 0.0, 1);  // across the cut of the full circle
  EXPECT_GE(contradictions(scan, points, {}).size(), 1U);
  for (double& range_m : scan.ranges_m) range_m = 81.83;
  EXPECT_EQ(contradictions(scan, points, {}).size(), 0U);
  EXPECT_EQ(contradictions({}, points, {}).size(), 0U);
}

}  // namespace setsquare::contradictions_test
