// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/pairs/study_sampling.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace setsquare::study_sampling_test {

TEST(StudySamplingTest, TimesAscendFromARandomPlaceOn) {
  const RobotPath path({{0.0, 0.0}, {80.0, 0.0}});
  Random random(3);
  double earliest = path.duration_s();
  double latest = 0.0;
  for (int i = 0; i < 20; ++i) {
    const std::vector<double> times = study_times(path, 16, random);
    ASSERT_EQ(times.size(), 16U);
    for (std::size_t k = 1; k < times.size(); ++k) {
      const double step_m =
          (path.pose_at(times[k]).translation() - path.pose_at(times[k - 1]).translation()).norm();
      EXPECT_GE(step_m, 1.99);
      EXPECT_LE(step_m, 4.01);
    }
    earliest = std::min(earliest, times.front());
    latest = std::max(latest, times.front());
  }
  EXPECT_GT(latest, earliest + 5.0);
}

TEST(StudySamplingTest, AShortPathIsSampledEvenly) {
  const RobotPath path({{0.0, 0.0}, {10.0, 0.0}});
  Random random(3);
  const std::vector<double> times = study_times(path, 6, random);
  ASSERT_EQ(times.size(), 6U);
  EXPECT_EQ(times.front(), 0.0);
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
}

}  // namespace setsquare::study_sampling_test
