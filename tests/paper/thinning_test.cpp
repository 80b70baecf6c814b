// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/paper/thinning.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/seed.hpp"

namespace setsquare::thinning_test {

bool is_nearer(const PointSet& kept, std::size_t k, double x_m, double y_m, double spacing_m) {
  const double dx_m = kept.x_m[k] - x_m;
  const double dy_m = kept.y_m[k] - y_m;
  return dx_m * dx_m + dy_m * dy_m < spacing_m * spacing_m;
}

/// The plain twin: every point against every kept one.
PointSet thin_by_all_pairs(const PointSet& points, double spacing_m) {
  PointSet kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool is_kept = true;
    for (std::size_t k = 0; k < kept.size(); ++k) {
      is_kept = is_kept && !is_nearer(kept, k, points.x_m[i], points.y_m[i], spacing_m);
    }
    if (is_kept) kept.push_back(points.x_m[i], points.y_m[i], points.beam[i]);
  }
  return kept;
}

void expect_equal(const PointSet& a, const PointSet& b) {
  EXPECT_EQ(a.x_m, b.x_m);
  EXPECT_EQ(a.y_m, b.y_m);
  EXPECT_EQ(a.beam, b.beam);
}

PointSet random_points(std::mt19937_64& generator, std::size_t num_points, double half_width_m) {
  PointSet points;
  for (std::size_t i = 0; i < num_points; ++i) {
    points.push_back(testing::uniform(generator, -half_width_m, half_width_m),
                     testing::uniform(generator, -half_width_m, half_width_m),
                     static_cast<std::int32_t>(i));
  }
  return points;
}

TEST(Thinning, EqualsItsPlainTwin) {
  std::mt19937_64 generator = testing::make_generator();
  for (const double half_width_m : {0.05, 0.3, 1.0, 10.0, 1e6}) {
    for (const std::size_t num_points : {1, 2, 50, 500}) {
      const PointSet points = random_points(generator, num_points, half_width_m);
      expect_equal(thin(points, 0.08), thin_by_all_pairs(points, 0.08));
    }
  }
}

TEST(Thinning, EqualsItsPlainTwinOnALattice) {
  PointSet points;  // Distances of exactly the spacing, which are kept, and cells' very edges.
  for (int i = -20; i <= 20; ++i) {
    for (int j = -20; j <= 20; ++j) points.push_back(0.0625 * i, 0.0625 * j, 41 * i + j);
  }
  for (const double spacing_m : {0.0625, 0.125, 0.07, 0.2}) {
    expect_equal(thin(points, spacing_m), thin_by_all_pairs(points, spacing_m));
  }
  EXPECT_EQ(thin(points, 0.0625).size(), points.size());
}

TEST(Thinning, NoTwoKeptPointsAreNearAndEveryDroppedOneHasAKeptNeighbour) {
  std::mt19937_64 generator = testing::make_generator();
  const PointSet points = random_points(generator, 400, 0.6);
  const PointSet kept = thin(points, 0.08);
  EXPECT_LT(kept.size(), points.size());
  EXPECT_TRUE(std::is_sorted(kept.beam.begin(), kept.beam.end()));
  for (std::size_t a = 0; a < kept.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      EXPECT_FALSE(is_nearer(kept, b, kept.x_m[a], kept.y_m[a], 0.08));
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::binary_search(kept.beam.begin(), kept.beam.end(), points.beam[i])) continue;
    bool has_neighbour = false;
    for (std::size_t k = 0; k < kept.size(); ++k) {
      has_neighbour = has_neighbour || is_nearer(kept, k, points.x_m[i], points.y_m[i], 0.08);
    }
    EXPECT_TRUE(has_neighbour);
  }
}

TEST(Thinning, DuplicatedPointsChangeNothing) {
  std::mt19937_64 generator = testing::make_generator();
  const PointSet points = random_points(generator, 200, 2.0);
  PointSet doubled;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int copy = 0; copy < 3; ++copy) {
      doubled.push_back(points.x_m[i], points.y_m[i], points.beam[i]);
    }
  }
  expect_equal(thin(doubled, 0.08), thin(points, 0.08));
}

TEST(Thinning, ThinningTwiceChangesNothing) {
  std::mt19937_64 generator = testing::make_generator();
  const PointSet once = thin(random_points(generator, 500, 1.0), 0.08);
  expect_equal(thin(once, 0.08), once);
}

TEST(Thinning, AcceptsNoPointsAndPointsFarAway) {
  EXPECT_TRUE(thin(PointSet{}, 0.08).empty());
  PointSet far;
  far.push_back(1e300, -1e300, 0);
  far.push_back(1e300, 1e300, 1);
  EXPECT_EQ(thin(far, 0.08).size(), 2U);
}

}  // namespace setsquare::thinning_test
