// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "setsquare/mapping/loops/candidates.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::position_hash_test {

using testing::uniform;

TEST(PositionHash, VisitsAllInTheSquareOnceAndNothingFarFromIt) {
  std::mt19937_64 generator = testing::make_generator();
  constexpr double kCell_m = 1.7;
  PositionHash hash(kCell_m);
  std::vector<Eigen::Vector2d> places_m;
  for (std::size_t i = 0; i < 3000; ++i) {  // Negative coordinates, too.
    places_m.emplace_back(uniform(generator, -30.0, 20.0), uniform(generator, -15.0, 15.0));
    hash.add(places_m.back(), i);
  }
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Vector2d centre_m(uniform(generator, -35.0, 25.0),
                                   uniform(generator, -20.0, 20.0));
    const double half_side_m = uniform(generator, 0.0, 8.0);
    std::vector<std::size_t> visited;
    hash.visit(centre_m, half_side_m, [&](std::size_t i) { visited.push_back(i); });
    std::sort(visited.begin(), visited.end());
    ASSERT_EQ(std::adjacent_find(visited.begin(), visited.end()), visited.end());
    for (std::size_t i = 0; i < places_m.size(); ++i) {
      const double off_m = (places_m[i] - centre_m).cwiseAbs().maxCoeff();
      const bool is_visited = std::binary_search(visited.begin(), visited.end(), i);
      if (off_m <= half_side_m) {
        ASSERT_TRUE(is_visited) << off_m;
      }
      if (off_m > half_side_m + kCell_m) {
        ASSERT_FALSE(is_visited) << off_m;
      }
    }
  }
}

}  // namespace setsquare::position_hash_test
