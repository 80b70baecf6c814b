// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/scan/isolated_returns.hpp"

#include <gtest/gtest.h>

#include "setsquare/scan/unchanged_share.hpp"

namespace setsquare::isolated_returns_test {

/// A wall all around, with every `stride`-th return at half its range.
Scan wall_with_returns_in_front(std::size_t stride) {
  Scan scan;
  scan.bearing_step_rad = rad_from_deg(0.25);
  scan.max_range_m = 30.0;
  scan.ranges_m.assign(1081, 4.0);
  for (std::size_t beam = 5; beam < scan.num_beams(); beam += stride) scan.ranges_m[beam] = 2.0;
  return scan;
}

TEST(IsolatedReturns, StandsAloneInFrontOfBothNeighbours) {
  Scan scan = wall_with_returns_in_front(100);
  EXPECT_TRUE(is_isolated_return(scan, 5));
  EXPECT_FALSE(is_isolated_return(scan, 4));
  scan.ranges_m[6] = 2.0;
  EXPECT_FALSE(is_isolated_return(scan, 5)) << "two side by side are a thing";
}

TEST(IsolatedReturns, TheLegOfAChairIsAThing) {
  Scan scan = wall_with_returns_in_front(100);
  scan.bearing_step_rad = rad_from_deg(1.0);  // up to 7 cm wide at 2 m
  EXPECT_EQ(num_isolated_returns(scan), 0U);
}

TEST(IsolatedReturns, ANoReturnBehindCountsAsFar) {
  Scan scan = wall_with_returns_in_front(100);
  scan.ranges_m[4] = scan.ranges_m[6] = 81.83;
  EXPECT_TRUE(is_isolated_return(scan, 5));
}

TEST(IsolatedReturns, AreLeftOutWhereThereAreMany) {
  EXPECT_FALSE(without_isolated_returns(wall_with_returns_in_front(200)).has_value());
  const Scan dusty = wall_with_returns_in_front(20);
  const auto cleared = without_isolated_returns(dusty);
  ASSERT_TRUE(cleared.has_value());
  for (std::size_t beam = 0; beam < dusty.num_beams(); ++beam) {
    const bool is_alone = is_isolated_return(dusty, beam);
    EXPECT_EQ(cleared->outcome(beam), is_alone ? BeamOutcome::kInvalid : BeamOutcome::kReturn);
  }
}

TEST(UnchangedShare, OfBeamsThatReturnInBoth) {
  Scan before = wall_with_returns_in_front(2000);
  Scan after = before;
  EXPECT_EQ(unchanged_share(before, after), 1.0);
  for (std::size_t beam = 0; beam < 540; ++beam) after.ranges_m[beam] = 3.0;
  EXPECT_NEAR(unchanged_share(before, after).value_or(0.0), 0.5, 0.01);
  after.ranges_m.assign(1081, 0.0);
  EXPECT_FALSE(unchanged_share(before, after).has_value());
  after.ranges_m.pop_back();
  EXPECT_FALSE(unchanged_share(before, after).has_value());
}

}  // namespace setsquare::isolated_returns_test
