// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/paper/dominant_direction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "setsquare/core/error.hpp"
#include "setsquare/paper/thinning.hpp"
#include "setsquare/scan/scan_to_points.hpp"
#include "tests/scan/random_points.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare::dominant_direction_test {

PointSet room_points(const Pose2& T_world_sensor) {
  return thin(points_from_scan(testing::scan_of_walls(testing::l_shaped_room(), T_world_sensor)),
              0.08);
}

/// Algorithm 2 as printed: every direction of the full turn, one profile each.
DominantDirection algorithm_2(const PointSet& points, const DominantDirectionParams& params) {
  DominantDirection best{0.0, 0.0};
  for (int j = 0; j < 3600; ++j) {
    const double theta_rad = -kPi + j * params.step_rad;
    const ProjectedProfile profile = projected_profile(points, theta_rad, params.bins);
    const double moment = direction_moment(profile.counts, params.moment);
    if (moment > best.moment) best = {theta_rad, moment};
  }
  return best;
}

class DominantDirectionReadings : public ::testing::TestWithParam<DirectionMoment> {};

TEST_P(DominantDirectionReadings, EqualsAlgorithm2AsPrinted) {
  std::mt19937_64 generator = testing::make_generator();
  DominantDirectionParams params;
  params.moment = GetParam();
  for (int i = 0; i < 4; ++i) {
    const PointSet points = i == 0 ? testing::random_points(generator, 60, 12.0)
                                   : room_points({1.3 + 0.5 * i, 2.1, 0.7 * i});
    const DominantDirection expected = algorithm_2(points, params);
    const DominantDirection found = dominant_direction(points, params);
    // The sums with omega^2 round differently for a profile and for its mirror image.
    EXPECT_NEAR(wrap_to_period(found.theta_rad - expected.theta_rad, kPi), 0.0, 1e-12);
    EXPECT_NEAR(found.moment, expected.moment, 1e-12 * expected.moment);
    EXPECT_LT(found.theta_rad, 0.0);
  }
}

TEST_P(DominantDirectionReadings, GrowsByTheSensorsTurnModuloHalfATurn) {
  DominantDirectionParams params;
  params.moment = GetParam();
  const PointSet points = room_points({2.0, 2.5, 0.2});
  const double before_rad = dominant_direction(points, params).theta_rad;
  for (const double turn_deg : {0.0, 0.1, 12.3, 90.0, 179.9, -60.0}) {
    const PointSet turned = testing::seen_after_turn(points, rad_from_deg(turn_deg));
    const double after_rad = dominant_direction(turned, params).theta_rad;
    const double error_rad = wrap_to_period(after_rad - before_rad - rad_from_deg(turn_deg), kPi);
    EXPECT_NEAR(error_rad, 0.0, 1e-9) << turn_deg << " deg";
  }
}

INSTANTIATE_TEST_SUITE_P(BothReadings,
                         DominantDirectionReadings,
                         ::testing::Values(DirectionMoment::kNeighbourDifferences,
                                           DirectionMoment::kSquaredFrequency));

TEST(DominantDirection, LaysTheWallsAlongTheAxes) {
  const Pose2 T_world_sensor{2.0, 2.5, 0.35};
  const double theta_rad = dominant_direction(room_points(T_world_sensor)).theta_rad;
  EXPECT_NEAR(wrap_to_period(theta_rad - 0.35, 0.5 * kPi), 0.0, rad_from_deg(0.5));
}

TEST(DirectionCurve, EqualsTheMomentOfEveryProfile) {
  std::mt19937_64 generator = testing::make_generator();
  const DirectionGrid grid{-1.0, rad_from_deg(0.7), 300};
  for (const std::size_t num_points : {1, 40, 9000}) {  // 9000: counts of 32 bits.
    const PointSet points = testing::random_points(generator, num_points, 11.0);
    const std::vector<double> curve = direction_curve(points, grid);
    for (std::size_t j = 0; j<grid.num_directions; j += num_points> 1000 ? 50 : 1) {
      const ProjectedProfile profile = projected_profile(points, grid.direction_rad(j));
      EXPECT_EQ(curve[j], direction_moment(profile.counts, DirectionMoment::kNeighbourDifferences));
    }
  }
}

TEST(DirectionCurve, BoundsTheMomentWithOmegaSquared) {
  std::mt19937_64 generator = testing::make_generator();
  const DirectionGrid grid{0.0, rad_from_deg(3.0), 60};
  for (const PointSet& points :
       {testing::random_points(generator, 100, 9.0), room_points({2.0, 2.5, 0.0})}) {
    const DirectionCurves curves = direction_curves(points, grid);
    for (std::size_t j = 0; j < grid.num_directions; ++j) {
      const ProjectedProfile profile = projected_profile(points, grid.direction_rad(j));
      const double moment = direction_moment(profile.counts, DirectionMoment::kSquaredFrequency);
      EXPECT_LE(curves.neighbour_differences[j], moment);
      EXPECT_GE(curves.squared_frequency_bound[j], moment);
    }
  }
}

TEST(DominantDirection, OfNoPointsOrOfPointsOutOfRangeHasNoMoment) {
  EXPECT_EQ(dominant_direction(PointSet{}).moment, 0.0);
  PointSet far;
  far.push_back(-1e300, 1.1e300, 0);  // Far from either axis, whatever the direction.
  EXPECT_EQ(dominant_direction(far).moment, 0.0);
  EXPECT_EQ(dominant_direction(far, {.moment = DirectionMoment::kSquaredFrequency}).moment, 0.0);
}

TEST(DominantDirection, RefusesAStepThatDoesNotDivideHalfATurn) {
  EXPECT_NO_THROW(DominantDirectionParams{}.validate());
  EXPECT_THROW((DominantDirectionParams{.step_rad = 0.0}.validate()), ParameterError);
  EXPECT_THROW((DominantDirectionParams{.step_rad = rad_from_deg(0.7)}.validate()), ParameterError);
}

}  // namespace setsquare::dominant_direction_test
