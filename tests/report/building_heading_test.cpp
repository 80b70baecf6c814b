// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/building_heading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "tests/support/rectangular_room.hpp"

namespace setsquare::building_heading_test {

double measured_heading_rad(const Pose2& T_map_room) {
  std::vector<Scan> scans;
  std::vector<Pose2> poses;
  for (int i = 0; i < 12; ++i) {
    const Pose2 T_room_sensor{1.0 + 0.9 * i, 2.0 + 0.2 * i, 0.4 * i};
    scans.push_back(testing::scan_of_room(T_room_sensor, 13.0, 6.0, 361));
    poses.push_back(T_map_room * T_room_sensor);
  }
  std::vector<PlacedScan> placed;
  for (std::size_t i = 0; i < scans.size(); ++i) placed.push_back({&scans[i], poses[i]});
  return building_heading_rad(placed);
}

TEST(BuildingHeading, FollowsTheRoomModuloAQuarterTurn) {
  for (const double heading_deg : {0.0, 0.37, 12.0, -33.3, 44.0, 61.0, 100.0, -170.0}) {
    const double heading_rad = rad_from_deg(heading_deg);
    const double measured_rad = measured_heading_rad({40.0, -25.0, heading_rad});
    EXPECT_GE(measured_rad, -0.25 * kPi);
    EXPECT_LT(measured_rad, 0.25 * kPi);
    const double error_rad = wrap_to_period(measured_rad - heading_rad, 0.5 * kPi);
    EXPECT_NEAR(deg_from_rad(error_rad), 0.0, 0.15) << "at " << heading_deg << " deg";
  }
}

TEST(BuildingHeading, NothingSeenIsZero) {
  EXPECT_EQ(building_heading_rad({}), 0.0);
  Scan scan;
  scan.bearing_step_rad = 0.01;
  scan.max_range_m = 10.0;
  scan.ranges_m.assign(100, 80.0);
  const PlacedScan placed{&scan, {1.0, 2.0, 3.0}};
  EXPECT_EQ(building_heading_rad({&placed, 1}), 0.0);
}

}  // namespace setsquare::building_heading_test
