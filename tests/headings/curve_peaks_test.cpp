// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/headings/curve_peaks.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace setsquare::curve_peaks_test {

TEST(HighestPeaks, FindsTheVertexOfAParabola) {
  std::vector<double> curve(20, 0.0);
  for (int k = 6; k <= 10; ++k) {
    curve[static_cast<std::size_t>(k)] = 10.0 - (k - 8.3) * (k - 8.3);
  }
  const auto peaks = highest_peaks(curve, 3, 2);
  ASSERT_EQ(peaks.size(), 1U);
  EXPECT_NEAR(peaks[0].position, 8.3, 1e-12);
  EXPECT_DOUBLE_EQ(peaks[0].value, curve[8]);
}

TEST(HighestPeaks, SortsSeparatesAndLimits) {
  const std::vector<double> curve = {0, 5, 0, 4, 0, 0, 0, 0, 3, 0, 0, 2, 0};
  const auto all = highest_peaks(curve, 10, 1);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].value, 5.0);
  EXPECT_EQ(all[3].value, 2.0);
  const auto apart = highest_peaks(curve, 10, 3);  // 4 is two from 5; 2 is three from 3.
  ASSERT_EQ(apart.size(), 3U);
  EXPECT_EQ(apart[1].value, 3.0);
  EXPECT_EQ(highest_peaks(curve, 2, 1).size(), 2U);
}

TEST(HighestPeaks, WrapsAround) {
  const std::vector<double> curve = {6, 2, 0, 0, 0, 0, 0, 0, 1, 5};
  const auto peaks = highest_peaks(curve, 5, 3);
  ASSERT_EQ(peaks.size(), 1U);
  EXPECT_NEAR(peaks[0].position, 9.7, 1e-12);  // Vertex of (2, 6, 5) about sample 0.
}

TEST(HighestPeaks, MeasuresAgainstTheMean) {
  EXPECT_DOUBLE_EQ(highest_peaks(std::vector<double>{0, 4, 0, 0}, 1, 1)[0].over_mean, 4.0);
  EXPECT_DOUBLE_EQ(highest_peaks(std::vector<double>{2, 2, 2, 2}, 1, 1)[0].over_mean, 1.0);
}

TEST(HighestPeaks, OfNothingAreNone) {
  EXPECT_TRUE(highest_peaks({}, 3, 1).empty());
  EXPECT_TRUE(highest_peaks(std::vector<double>{0, 0, 0}, 3, 1).empty());
}

}  // namespace setsquare::curve_peaks_test
