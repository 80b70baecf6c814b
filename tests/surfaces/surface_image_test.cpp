// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/surfaces/surface_image.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::surface_image_test {

using testing::Fan;
using testing::uniform;

const Fan kFans[] = {{11, rad_from_deg(-90), rad_from_deg(18)},
                     {180, rad_from_deg(-90), rad_from_deg(1)},
                     {361, rad_from_deg(90), rad_from_deg(-0.5)},
                     {360, rad_from_deg(-180), rad_from_deg(1)},
                     {361, rad_from_deg(180), rad_from_deg(-1)},
                     {1081, rad_from_deg(-135), rad_from_deg(0.25)}};

/// The beam whose bearing is nearest, and how far that is: the plain twin of a look-up. The later
/// of two that look the same way, as at the seam of a full turn.
struct NearestBeam {
  std::size_t beam = 0;
  double distance_rad = 1e9;
};

NearestBeam nearest_beam(const Scan& scan, double bearing_rad) {
  NearestBeam nearest;
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    const double distance_rad = std::abs(wrap_to_pi(scan.bearing_rad(beam) - bearing_rad));
    constexpr double kSame_rad = 1e-9;
    if (distance_rad < nearest.distance_rad + kSame_rad) nearest = {beam, distance_rad};
  }
  return nearest;
}

class SurfaceImageOf : public ::testing::TestWithParam<Fan> {};

TEST_P(SurfaceImageOf, ShowsTheNearestBeamsSurface) {
  auto generator = testing::make_generator();
  const auto room = testing::furnished_room(generator);
  const Scan scan = testing::scan_of_walls(
      room.walls, testing::free_pose(room, generator), GetParam(), 0.01, 1, 0.2);
  const SurfacePoints points = surface_points_from_scan(scan);
  const SurfaceImage image(scan, points);
  const double half_step_rad = 0.5 * std::abs(scan.bearing_step_rad);
  std::size_t num_compared = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    const double bearing_rad = uniform(generator, -kPi, kPi);
    const double range_m = uniform(generator, 0.01, 20.0);
    const auto x_m = static_cast<float>(range_m * std::cos(bearing_rad));
    const auto y_m = static_cast<float>(range_m * std::sin(bearing_rad));
    const SurfaceSector& sector = image.at(x_m, y_m);
    const NearestBeam nearest = nearest_beam(scan, bearing_rad);
    // Within a sector's width of the border between two beams either may be shown.
    const double diamond_m = std::abs(std::cos(bearing_rad)) + std::abs(std::sin(bearing_rad));
    const double border_rad =
        4.0 / static_cast<double>(image.num_sectors()) * diamond_m * diamond_m;
    if (std::abs(nearest.distance_rad - half_step_rad) < border_rad) continue;
    ++num_compared;
    const auto point =
        std::find(points.beam.begin(), points.beam.end(), static_cast<std::int32_t>(nearest.beam));
    const bool has_surface = nearest.distance_rad < half_step_rad && point != points.beam.end();
    ASSERT_EQ(sector.offset_m != SurfaceImage::kNoSurface_m, has_surface) << bearing_rad;
    if (!has_surface) continue;
    const auto i = static_cast<std::size_t>(point - points.beam.begin());
    EXPECT_NEAR(SurfaceImage::signed_distance_m(sector, points.x_m[i], points.y_m[i]), 0.0, 1e-4);
    if (points.normal_x[i] == 0.0F && points.normal_y[i] == 0.0F) continue;
    EXPECT_EQ(sector.normal_x, points.normal_x[i]);
    EXPECT_EQ(sector.normal_y, points.normal_y[i]);
  }
  EXPECT_GT(num_compared, 1000U);
}

TEST_P(SurfaceImageOf, CallsNothingFreeThatIsBehindAWall) {
  auto generator = testing::make_generator();
  const auto room = testing::furnished_room(generator);
  const Pose2 pose = testing::free_pose(room, generator);
  const Scan scan = testing::scan_of_walls(room.walls, pose, GetParam());
  const SurfaceImage image(scan, surface_points_from_scan(scan));
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    const double bearing_rad = scan.bearing_rad(beam);
    const SurfaceSector& sector = image.at(static_cast<float>(std::cos(bearing_rad)),
                                           static_cast<float>(std::sin(bearing_rad)));
    EXPECT_LE(std::sqrt(sector.free_square_m2), scan.ranges_m[beam]) << "beam " << beam;
  }
}

TEST_P(SurfaceImageOf, LooksUpFourPointsAsOne) {
  auto generator = testing::make_generator();
  const Scan scan = testing::scan_of_walls(testing::l_shaped_room(), {2, 2, 0.2}, GetParam());
  const SurfaceImage image(scan, surface_points_from_scan(scan));
  for (int trial = 0; trial < 2000; ++trial) {
    Floats x_m{};
    Floats y_m{};
    for (int lane = 0; lane < 4; ++lane) {
      x_m[lane] = static_cast<float>(uniform(generator, -9.0, 9.0));
      y_m[lane] = trial % 5 == 0 ? 0.0F : static_cast<float>(uniform(generator, -9.0, 9.0));
    }
    const Ints indices = image.sector_indices(x_m, y_m);
    for (int lane = 0; lane < 4; ++lane) {
      EXPECT_EQ(indices[lane], image.sector_index(x_m[lane], y_m[lane]));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Fans, SurfaceImageOf, ::testing::ValuesIn(kFans));

TEST(SurfaceImage, DiamondAngleGrowsWithTheBearing) {
  float last = -1.01F;
  for (int k = -900; k < 2700; ++k) {
    const double bearing_rad = rad_from_deg(0.1 * k);
    const float angle = SurfaceImage::diamond_angle(static_cast<float>(std::cos(bearing_rad)),
                                                    static_cast<float>(std::sin(bearing_rad)));
    EXPECT_GT(angle, last) << 0.1 * k << " deg";
    last = angle;
  }
  EXPECT_LT(last, 3.0F);
}

TEST(SurfaceImage, AnswersAtTheSensorItself) {
  const Scan scan =
      testing::scan_of_walls(testing::l_shaped_room(), {2, 2, 0.2}, {360, -kPi, rad_from_deg(1)});
  const SurfaceImage image(scan, surface_points_from_scan(scan));
  for (const float zero : {0.0F, -0.0F}) {
    const std::int32_t index = image.sector_index(zero, zero);
    ASSERT_GE(index, 0);
    ASSERT_LT(static_cast<std::size_t>(index), image.num_sectors());
    EXPECT_EQ(&image.at(zero, zero), &image.sector(index));
  }
}

/// How far the image calls the direction of a scan's only kind of beam free.
double free_m(double range_m, double max_range_m, const SurfaceParams& params = {}) {
  Scan scan = testing::scan_of_walls({}, {}, {90, -0.5, 0.01});
  scan.max_range_m = max_range_m;
  scan.ranges_m.assign(90, range_m);
  const SurfaceImage image(scan, surface_points_from_scan(scan, params));
  return std::sqrt(image.at(1.0F, 0.0F).free_square_m2);
}

TEST(SurfaceImage, ANoReturnFreesNoMoreThanTheSensorReaches) {
  EXPECT_NEAR(free_m(81.83, 30.0), 6.0 * 0.97 - 0.2, 1e-5);
  EXPECT_NEAR(free_m(4.095, 4.0), 4.0 * 0.97 - 0.2, 1e-5);  // A sensor that reaches 4 m.
  // Returns that the matcher does not use still end the free space.
  EXPECT_NEAR(free_m(3.5, 30.0, {.max_range_m = 3.0}), 3.5 * 0.97 - 0.2, 1e-5);
  EXPECT_EQ(free_m(0.0, 30.0), 0.0);
}

TEST(SurfaceImage, StaysFiniteForReturnsAtTheSensor) {
  Scan scan = testing::scan_of_walls(testing::l_shaped_room(), {2, 2, 0}, {90, -0.5, 0.01});
  for (const double range_m : {5e-324, 1e-60, 1e-42, 1e-30, 1e-6, 0.005}) {
    scan.ranges_m.assign(90, range_m);
    const SurfaceImage image(scan, surface_points_from_scan(scan));
    for (std::size_t k = 0; k < image.num_sectors(); ++k) {
      const SurfaceSector& sector = image.sector(static_cast<std::int32_t>(k));
      ASSERT_TRUE(std::isfinite(sector.normal_x)) << range_m;
      ASSERT_TRUE(std::isfinite(sector.normal_y)) << range_m;
      ASSERT_TRUE(std::isfinite(sector.offset_m)) << range_m;
    }
  }
}

}  // namespace setsquare::surface_image_test
