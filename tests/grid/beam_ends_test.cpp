// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/grid/beam_ends.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"

namespace setsquare::beam_ends_test {

constexpr double kFar_m = 81.83;  // a sensor's code for "nothing there"
const double kNan = std::nan("");

/// Beams a degree apart, the first straight ahead.
Scan fan(const std::vector<double>& ranges_m) {
  Scan scan;
  scan.bearing_step_rad = rad_from_deg(1.0);
  scan.max_range_m = 50.0;
  scan.ranges_m = ranges_m;
  return scan;
}

/// One letter per end: R return, J joined return, n no-return.
std::string words_of(const std::vector<double>& ranges_m, const BeamEndParams& params = {}) {
  std::string words;
  for (const BeamEnd& end : beam_ends(fan(ranges_m), params)) {
    words += end.is_joined ? 'J' : end.is_return ? 'R' : 'n';
  }
  return words;
}

TEST(BeamEnds, LieWhereTheRangesSay) {
  const auto ends = beam_ends(fan({2.0, kFar_m, kFar_m, kFar_m}), {.max_no_return_range_m = 3.0});
  ASSERT_EQ(ends.size(), 4U);
  EXPECT_EQ(ends[0].x_m, 2.0);
  EXPECT_EQ(ends[0].y_m, 0.0);
  EXPECT_TRUE(ends[0].is_return);
  EXPECT_NEAR(std::hypot(ends[2].x_m, ends[2].y_m), 3.0, 1e-12);
  EXPECT_NEAR(std::atan2(ends[2].y_m, ends[2].x_m), rad_from_deg(2.0), 1e-12);
  EXPECT_FALSE(ends[2].is_return);
}

TEST(BeamEnds, LoneNoReturnsAreDropOuts) {
  EXPECT_EQ(words_of({5, kFar_m, 5, kFar_m, kFar_m, 5}), "RJR");
  EXPECT_EQ(words_of({5, kFar_m, kFar_m, kFar_m, 5}), "RnnnR");
  EXPECT_EQ(words_of({kFar_m, kFar_m, kFar_m}), "nnn");
  EXPECT_EQ(words_of({kFar_m, kFar_m}), "");
  EXPECT_EQ(words_of({kFar_m, kNan, kFar_m, kFar_m}), "") << "a beam without information separates";
  EXPECT_EQ(words_of({kFar_m}, {.min_neighbouring_no_returns = 1}), "n");
}

TEST(BeamEnds, NeighbouringReturnsNearEachOtherAreJoined) {
  EXPECT_EQ(words_of({5, 5.1, 9, 9.1}), "RJRJ");
  EXPECT_EQ(words_of({5, kNan, 5, kNan, kNan, 5}), "RJR") << "one beam may be missed, not two";
  EXPECT_EQ(words_of({5, 5.1, 5.2}, {.max_joint_m = 0.0}), "RRR");
}

TEST(BeamEnds, AReturnTooFarCountsAsNoReturn) {
  EXPECT_EQ(words_of({12, 12, 12, 9}, {.max_return_range_m = 10.0}), "nnnR");
}

TEST(BeamEnds, InvalidBeamsHaveNoInformation) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(words_of({kNan, 0.0, -1.0, -inf}), "");
}

TEST(BeamEnds, AFinderFollowsTheGeometryOfEachScan) {
  BeamEndFinder finder;
  Scan scan = fan({1, 2, 3});
  EXPECT_EQ(finder.find(scan)[2].x_m, beam_ends(scan)[2].x_m);
  scan.first_bearing_rad = 1.0;
  EXPECT_NEAR(finder.find(scan)[0].y_m, std::sin(1.0), 1e-12);
  scan.bearing_step_rad = -0.5;
  EXPECT_NEAR(finder.find(scan)[2].y_m, 0.0, 1e-12);
  scan.ranges_m.push_back(2.0);
  EXPECT_NEAR(finder.find(scan)[3].y_m, 2.0 * std::sin(-0.5), 1e-12);
}

TEST(BeamEnds, ParametersAreChecked) {
  EXPECT_THROW(BeamEndParams{.max_return_range_m = 0.0}.validate(), ParameterError);
  EXPECT_THROW(BeamEndParams{.max_no_return_range_m = -1.0}.validate(), ParameterError);
  EXPECT_THROW(BeamEndParams{.min_neighbouring_no_returns = 0}.validate(), ParameterError);
  EXPECT_THROW(BeamEndParams{.max_joint_m = kNan}.validate(), ParameterError);
}

}  // namespace setsquare::beam_ends_test
