// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/surfaces/surface_samples.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::surface_samples_test {

double total(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

SurfacePoints random_points(std::mt19937_64& generator, std::size_t num_beams) {
  const auto room = testing::furnished_room(generator);
  const testing::Fan fan{num_beams, -kPi, kTwoPi / static_cast<double>(num_beams)};
  return surface_points_from_scan(
      testing::scan_of_walls(room.walls, testing::free_pose(room, generator), fan, 0.01));
}

/// Index in `points` of each sample, searched forward only; the points' number where one is none.
std::vector<std::size_t> places_in_order(const SurfaceSamples& samples,
                                         const SurfacePoints& points) {
  std::vector<std::size_t> places;
  std::size_t i = 0;
  for (std::size_t k = 0; k < samples.size(); ++k, ++i) {
    while (i < points.size() &&
           (points.x_m[i] != samples.x_m[k] || points.y_m[i] != samples.y_m[k]))
      ++i;
    places.push_back(i);
  }
  return places;
}

class SampleSurface : public ::testing::TestWithParam<std::size_t> {};

TEST_P(SampleSurface, KeepsTheWallsLengthAndTheBeamsOrder) {
  const std::size_t max_samples = GetParam();
  auto generator = testing::make_generator();
  for (const std::size_t num_beams : {11U, 60U, 180U, 361U, 1081U}) {
    const SurfacePoints points = random_points(generator, num_beams);
    const SurfaceSamples samples = sample_surface(points, max_samples);
    ASSERT_GT(samples.size(), 0U);
    EXPECT_LE(samples.size(), max_samples);
    EXPECT_NEAR(total(samples.weight_m), total(points.weight_m), 1e-5 * total(points.weight_m));
    const auto places = places_in_order(samples, points);
    for (std::size_t k = 0; k < places.size(); ++k) {
      ASSERT_LT(places[k], points.size()) << "sample " << k << " is no point, or out of order";
      EXPECT_EQ(samples.normal_x[k], points.normal_x[places[k]]);
      EXPECT_EQ(samples.normal_y[k], points.normal_y[places[k]]);
    }
  }
}

TEST_P(SampleSurface, SpacesThemEvenlyAlongTheWall) {
  const std::size_t max_samples = GetParam();
  auto generator = testing::make_generator();
  const SurfacePoints points = random_points(generator, 720);
  const SurfaceSamples samples = sample_surface(points, max_samples);
  const auto places = places_in_order(samples, points);
  // Up to any sample, the samples stand for the wall up to there: within half a step and a point.
  const double step_m = total(points.weight_m) / static_cast<double>(max_samples);
  double sampled_m = 0.0;
  double walked_m = 0.0;
  std::size_t next = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    sampled_m += samples.weight_m[k];
    for (; next <= places[k]; ++next) walked_m += points.weight_m[next];
    EXPECT_NEAR(sampled_m, walked_m, 0.5 * step_m + 1e-3) << "sample " << k;
  }
}

TEST_P(SampleSurface, PadsWithNothing) {
  auto generator = testing::make_generator();
  const SurfaceSamples samples = sample_surface(random_points(generator, 361), GetParam());
  EXPECT_EQ(samples.padded_size() % 4, 0U);
  EXPECT_LT(samples.padded_size(), samples.size() + 4);
  for (const auto* array :
       {&samples.x_m, &samples.y_m, &samples.normal_x, &samples.normal_y, &samples.weight_m}) {
    ASSERT_EQ(array->size(), samples.padded_size());
    for (std::size_t k = samples.size(); k < array->size(); ++k) EXPECT_EQ((*array)[k], 0.0F);
  }
}

INSTANTIATE_TEST_SUITE_P(Counts, SampleSurface, ::testing::Values(1, 7, 60, 300));

TEST(SampleSurface, TakesAllPointsWhereTheyAreNoMore) {
  auto generator = testing::make_generator();
  const SurfacePoints points = random_points(generator, 181);
  const SurfaceSamples samples = sample_surface(points, points.size());
  ASSERT_EQ(samples.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(samples.x_m[i], points.x_m[i]);
    EXPECT_EQ(samples.weight_m[i], points.weight_m[i]);
  }
  EXPECT_EQ(sample_surface({}, 60).size(), 0U);
}

}  // namespace setsquare::surface_samples_test
