// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/scan/scan_to_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace setsquare::scan_to_points_test {

/// Every point at its beam's range and bearing.
void expect_points_on_beams(const Scan& scan) {
  const PointSet points = points_from_scan(scan);
  ASSERT_EQ(points.size(), scan.num_beams());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points.beam[i], static_cast<std::int32_t>(i));
    EXPECT_NEAR(std::hypot(points.x_m[i], points.y_m[i]), scan.ranges_m[i], 1e-12);
    const double bearing_rad = std::atan2(points.y_m[i], points.x_m[i]);
    EXPECT_NEAR(wrap_to_pi(bearing_rad - scan.bearing_rad(i)), 0.0, 1e-12);
  }
}

Scan fan(std::size_t num_beams, double first_rad, double step_rad) {
  Scan scan;
  scan.first_bearing_rad = first_rad;
  scan.bearing_step_rad = step_rad;
  scan.max_range_m = 30.0;
  for (std::size_t beam = 0; beam < num_beams; ++beam) {
    scan.ranges_m.push_back(1.0 + 0.01 * static_cast<double>(beam));
  }
  return scan;
}

TEST(PointsFromScan, PutsEveryReturnOnItsBeam) {
  expect_points_on_beams(fan(180, -0.5 * kPi, rad_from_deg(1.0)));
  expect_points_on_beams(fan(1081, rad_from_deg(-135.0), rad_from_deg(0.25)));
  expect_points_on_beams(fan(360, -kPi, rad_from_deg(1.0)));
  expect_points_on_beams(fan(720, kPi, rad_from_deg(-0.5)));  // Clockwise.
  expect_points_on_beams(fan(1, 0.3, 0.0));
}

TEST(PointsFromScan, LeavesOutWhatIsNoReturn) {
  Scan scan = fan(6, 0.0, 0.1);
  scan.ranges_m = {2.0,
                   std::numeric_limits<double>::quiet_NaN(),
                   30.0,
                   0.0,
                   3.0,
                   std::numeric_limits<double>::infinity()};
  const PointSet points = points_from_scan(scan);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points.beam[0], 0);
  EXPECT_EQ(points.beam[1], 4);
}

TEST(PointsFromScan, AnEmptyScanHasNoPoints) { EXPECT_TRUE(points_from_scan(Scan{}).empty()); }

}  // namespace setsquare::scan_to_points_test
