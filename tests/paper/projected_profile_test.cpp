// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/paper/projected_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "tests/scan/random_points.hpp"

namespace setsquare::projected_profile_test {

/// f of eq. (6), literally.
int f(double rho_m, int kappa, const ProfileBins& bins) {
  return kappa * bins.bin_width_m - bins.max_distance_m < rho_m &&
                 rho_m <= (kappa + 1) * bins.bin_width_m - bins.max_distance_m
             ? 1
             : 0;
}

TEST(ProjectedProfile, EqualsEquationsFourToSixLiterally) {
  std::mt19937_64 generator = testing::make_generator();
  const ProfileBins bins;
  const PointSet points = testing::random_points(generator, 60, 12.0);
  for (const double theta_rad : {0.0, 0.3, -2.0, 1.6}) {
    const ProjectedProfile profile = projected_profile(points, theta_rad, bins);
    ASSERT_EQ(profile.counts.size(), 500U);
    for (int kappa = 0; kappa < 500; ++kappa) {
      int count = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double range_m = std::hypot(points.x_m[i], points.y_m[i]);
        const double bearing_rad = std::atan2(points.y_m[i], points.x_m[i]);
        count += f(range_m * std::sin(bearing_rad + theta_rad), kappa, bins);
      }
      EXPECT_EQ(profile.counts[static_cast<std::size_t>(kappa)], count) << "bin " << kappa;
    }
  }
}

TEST(ProjectedProfile, BinsAreOpenBelowAndClosedAbove) {
  const ProfileBins bins{0.25, 1.0};
  const std::vector<double> edges_m = {-1.0, -0.75, 0.0, 1.0, 1.25};
  const std::vector<std::int32_t> expected = {1, 0, 0, 1, 0, 0, 0, 1};
  EXPECT_EQ(profile_of_coordinates(edges_m, bins).counts, expected);
}

TEST(ProjectedProfile, MassIsTheNumberOfPointsInRange) {
  std::mt19937_64 generator = testing::make_generator();
  const PointSet points = testing::random_points(generator, 300, 14.0);
  for (const double theta_rad : {0.0, 1.0, 2.5}) {
    std::int64_t num_in_range = 0;
    for (const double rho_m : project(points, theta_rad)) {
      num_in_range += std::abs(rho_m) < 10.0 ? 1 : 0;
    }
    EXPECT_LT(num_in_range, 300);
    EXPECT_EQ(projected_profile(points, theta_rad).mass(), num_in_range);
  }
}

TEST(ProjectedProfile, CoordinateIsYOfTheTurnedScan) {
  PointSet points;
  points.push_back(3.0, 0.0, 0);
  EXPECT_NEAR(project(points, 0.5 * kPi)[0], 3.0, 1e-15);
  EXPECT_NEAR(project(points, 0.0)[0], 0.0, 1e-15);
  EXPECT_NEAR(project(points, kPi)[0], 0.0, 1e-15);
}

TEST(ProjectedProfile, AWallMakesOnePeakAndAnObliqueOneNone) {
  PointSet wall;
  for (int i = 0; i < 50; ++i) wall.push_back(0.1 * i - 2.5, 1.01, i);
  const auto highest = [&wall](double theta_rad) {
    const ProjectedProfile profile = projected_profile(wall, theta_rad);
    return *std::max_element(profile.counts.begin(), profile.counts.end());
  };
  EXPECT_EQ(highest(0.0), 50);
  EXPECT_LE(highest(rad_from_deg(45.0)), 1);
}

TEST(ProjectedProfile, NothingInNothingOut) {
  EXPECT_EQ(projected_profile(PointSet{}, 0.3).mass(), 0);
}

TEST(ProfileBins, RefusesBinsThatDoNotFillTheRange) {
  EXPECT_NO_THROW(ProfileBins{}.validate());
  EXPECT_THROW((ProfileBins{0.03, 10.0}.validate()), ParameterError);
  EXPECT_THROW((ProfileBins{0.0, 10.0}.validate()), ParameterError);
  EXPECT_THROW((ProfileBins{0.04, -1.0}.validate()), ParameterError);
  EXPECT_THROW((ProfileBins{1e-9, 10.0}.validate()), ParameterError);
}

}  // namespace setsquare::projected_profile_test
