// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "setsquare/surfaces/angle_histogram.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::direction_balance_test {

/// `count` points of 10 cm of wall that faces a direction; clutter where there is none.
struct Stretch {
  int count;
  double facing_rad;
  bool is_clutter = false;
};

SurfacePoints points_of(const std::vector<Stretch>& stretches) {
  SurfacePoints points;
  for (const Stretch& stretch : stretches) {
    for (int i = 0; i < stretch.count; ++i) {
      const double keep = stretch.is_clutter ? 0.0 : 1.0;
      points.x_m.push_back(0.1F * static_cast<float>(i));
      points.y_m.push_back(2.0F);
      points.normal_x.push_back(static_cast<float>(keep * std::cos(stretch.facing_rad)));
      points.normal_y.push_back(static_cast<float>(keep * std::sin(stretch.facing_rad)));
      points.weight_m.push_back(0.1F);
      points.range_m.push_back(2.0F);
      points.beam.push_back(i);
      points.joined.push_back(1);
    }
  }
  return points;
}

std::vector<float> balanced(const SurfacePoints& points) {
  return direction_balanced_weights(points, angle_histogram(points));
}

float sum(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0F);
}

SurfacePoints points_in_a_room(std::mt19937_64& generator) {
  const auto room = testing::furnished_room(generator);
  const testing::Fan fan{720, -kPi, rad_from_deg(0.5)};
  return surface_points_from_scan(
      testing::scan_of_walls(room.walls, testing::free_pose(room, generator), fan, 0.01));
}

constexpr double kBin_rad = kTwoPi / AngleHistogram::kNumBins;
/// The middle of a bin.
constexpr double kEast_rad = 0.5 * kBin_rad;
constexpr double kNorth_rad = kEast_rad + 0.5 * kPi;

TEST(DirectionBalance, KeepsTheSum) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 20; ++trial) {
    const SurfacePoints points = points_in_a_room(generator);
    const auto weights = balanced(points);
    ASSERT_EQ(weights.size(), points.size());
    EXPECT_NEAR(sum(weights), sum(points.weight_m), 1e-4F * sum(points.weight_m));
    for (const float weight_m : weights) EXPECT_GT(weight_m, 0.0F);
  }
}

TEST(DirectionBalance, AMetreCountsByTheInverseRootOfItsDirectionsShare) {
  const auto weights = balanced(points_of({{90, kNorth_rad}, {10, kEast_rad}}));
  EXPECT_NEAR(weights.back() / weights.front(), std::sqrt(90.0 / 10.0), 1e-3);
}

TEST(DirectionBalance, WallsThatFaceEachOtherRunOneWay) {
  const auto weights =
      balanced(points_of({{50, kNorth_rad}, {10, kEast_rad}, {40, kNorth_rad - kPi}}));
  EXPECT_NEAR(weights.front(), weights.back(), 1e-6);
  EXPECT_NEAR(weights[50] / weights.front(), 3.0, 1e-3);
}

TEST(DirectionBalance, ASinglePostIsNoWall) {
  const auto weights = balanced(points_of({{999, kNorth_rad}, {1, kEast_rad}}));
  EXPECT_NEAR(weights.back() / weights.front(), std::sqrt(0.999 / 0.03), 1e-2);
}

TEST(DirectionBalance, ClutterKeepsItsWeightUpToTheCommonFactor) {
  const auto weights = balanced(points_of({{90, kNorth_rad}, {10, kEast_rad}, {30, 0.0, true}}));
  // Of walls alone, 90 % run north's way: clutter neither makes a direction rarer nor is one.
  EXPECT_NEAR(weights.back() / weights.front(), std::sqrt(0.9), 1e-3);
  EXPECT_NEAR(weights[90] / weights.back(), std::sqrt(10.0), 1e-2);
  for (int i = 100; i < 130; ++i) EXPECT_EQ(weights[i], weights.back());
}

TEST(DirectionBalance, ClutterAloneAndNothingStayAsTheyAre) {
  const auto weights = balanced(points_of({{30, 0.0, true}}));
  for (const float weight_m : weights) EXPECT_NEAR(weight_m, 0.1F, 1e-6F);
  EXPECT_TRUE(balanced({}).empty());
}

TEST(DirectionBalance, ATurnByWholeBinsChangesNoWeight) {
  const std::vector<Stretch> stretches = {
      {70, kEast_rad}, {20, kNorth_rad}, {15, kEast_rad + 20 * kBin_rad}, {10, 0.0, true}};
  const auto before = balanced(points_of(stretches));
  for (int num_bins = 1; num_bins < AngleHistogram::kNumBins; num_bins += 7) {
    auto turned = stretches;
    for (Stretch& stretch : turned) stretch.facing_rad += num_bins * kBin_rad;
    const auto after = balanced(points_of(turned));
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i], 1e-5F);
  }
}

}  // namespace setsquare::direction_balance_test
