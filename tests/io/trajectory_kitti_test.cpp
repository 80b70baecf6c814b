// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/tables/trajectory_kitti.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>

#include "tests/support/seed.hpp"

namespace setsquare::trajectory_kitti_test {

TEST(TrajectoryKitti, ByHand) {
  EXPECT_EQ(kitti_from_trajectory({{timestamp_from_seconds(7.0), {1.5, -2.0, 0.5 * kPi}}}),
            "0.000000000 -1.000000000 0 1.500000 1.000000000 0.000000000 0 -2.000000 0 0 1 0\n");
  EXPECT_EQ(kitti_from_trajectory({}), "");
}

// Read as others read it: twelve numbers, a matrix of three rows that maps points.
TEST(TrajectoryKitti, TheMatrixMapsPointsAsThePoseDoes) {
  auto generator = testing::make_generator();
  Trajectory trajectory;
  for (int i = 0; i < 50; ++i) {
    trajectory.push_back({timestamp_from_seconds(i),
                          {testing::uniform(generator, -50.0, 50.0),
                           testing::uniform(generator, -50.0, 50.0),
                           testing::uniform(generator, -kPi, kPi)}});
  }
  std::istringstream lines(kitti_from_trajectory(trajectory));
  for (const StampedPose& stamped : trajectory) {
    std::array<double, 12> m{};
    for (double& value : m) ASSERT_TRUE(lines >> value);
    const Eigen::Vector2d p(testing::uniform(generator, -9.0, 9.0), 2.0);
    const Eigen::Vector2d expected = stamped.pose * p;
    EXPECT_NEAR(m[0] * p.x() + m[1] * p.y() + m[3], expected.x(), 1e-6);
    EXPECT_NEAR(m[4] * p.x() + m[5] * p.y() + m[7], expected.y(), 1e-6);
    EXPECT_EQ(m[10], 1.0);
    EXPECT_EQ(m[2] + m[6] + m[8] + m[9] + m[11], 0.0);
  }
  double more = 0.0;
  EXPECT_FALSE(lines >> more);
}

}  // namespace setsquare::trajectory_kitti_test
