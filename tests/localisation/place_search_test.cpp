// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "setsquare/localisation/localisation_params.hpp"

namespace setsquare::place_search_test {

TEST(PlaceSearchParams, ASmallMapIsSearchedWithFewerPlaces) {
  const PlaceSearchParams params{.num_proposals = 400, .num_compared = 120, .num_verified = 30};
  const PlaceSearchParams small = params.in_area(180.0);
  EXPECT_EQ(small.num_proposals, 80U);
  EXPECT_EQ(small.num_compared, 24U);
  EXPECT_EQ(small.num_verified, 6U);
  EXPECT_EQ(small.num_rotations, params.num_rotations);
}

TEST(PlaceSearchParams, ALargeMapIsSearchedWithAll) {
  const PlaceSearchParams params;
  EXPECT_EQ(params.in_area(300.0).num_proposals, params.num_proposals);
  EXPECT_EQ(params.in_area(2000.0).num_verified, params.num_verified);
}

TEST(PlaceSearchParams, NeverWithNone) {
  const PlaceSearchParams params{.num_proposals = 1, .num_compared = 1, .num_verified = 1};
  EXPECT_EQ(params.in_area(0.0).num_proposals, 1U);
  EXPECT_EQ(params.in_area(0.0).num_compared, 1U);
  EXPECT_EQ(params.in_area(0.0).num_verified, 1U);
}

TEST(PlaceSearchParams, GrowWithTheMap) {
  const PlaceSearchParams params;
  std::size_t before = 0;
  for (double free_m2 = 0.0; free_m2 < 500.0; free_m2 += 5.0) {
    const std::size_t number = params.in_area(free_m2).num_proposals;
    EXPECT_GE(number, before) << free_m2 << " m2";
    before = number;
  }
}

}  // namespace setsquare::place_search_test
