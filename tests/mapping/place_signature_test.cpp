// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/pieces/place_signature.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/mapping/tracked_world.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::place_signature_test {

using testing::uniform;
using testing::Wall;

SurfaceSamples samples_from(const std::vector<Wall>& walls, const Pose2& T_world_sensor) {
  const Scan scan = scan_of_walls(walls, T_world_sensor, testing::kAllAround);
  const SurfacePoints points = surface_points_from_scan(scan);
  return sample_surface(points, points.size());
}

/// The same samples in another frame.
SurfaceSamples moved(SurfaceSamples samples, const Pose2& T) {
  const Pose2 turn{0.0, 0.0, T.theta_rad};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Eigen::Vector2d p = T * Eigen::Vector2d(samples.x_m[i], samples.y_m[i]);
    const Eigen::Vector2d n = turn * Eigen::Vector2d(samples.normal_x[i], samples.normal_y[i]);
    samples.x_m[i] = static_cast<float>(p.x());
    samples.y_m[i] = static_cast<float>(p.y());
    samples.normal_x[i] = static_cast<float>(n.x());
    samples.normal_y[i] = static_cast<float>(n.y());
  }
  return samples;
}

PlaceSignature random_signature(std::mt19937_64& generator) {
  PlaceSignature signature;
  for (float& value : signature.along_x) value = static_cast<float>(uniform(generator, 0.0, 0.3));
  for (float& value : signature.along_y) value = static_cast<float>(uniform(generator, 0.0, 0.3));
  return signature;
}

TEST(PlaceSignature, IsTheSameInAnyFrameOfKnownHeading) {
  std::mt19937_64 generator = testing::make_generator();
  const SurfaceSamples samples = samples_from(testing::l_shaped_room(), {2.0, 3.0, 0.0});
  const PlaceSignature original = place_signature(samples, 0.0);
  for (int trial = 0; trial < 20; ++trial) {
    const Pose2 T{uniform(generator, -9.0, 9.0),
                  uniform(generator, -9.0, 9.0),
                  uniform(generator, -kPi, kPi)};
    const PlaceSignature other = place_signature(moved(samples, T), -T.theta_rad);
    EXPECT_LT(signature_distance(original, other), 1e-3);
  }
}

TEST(PlaceSignature, QuarterTurnsOfTheHeadingDoNoHarm) {
  const SurfaceSamples samples = samples_from(testing::l_shaped_room(), {2.0, 3.0, 0.0});
  const PlaceSignature original = place_signature(samples, 0.0);
  for (const double turn_rad : {0.5 * kPi, kPi, -0.5 * kPi}) {
    EXPECT_LT(signature_distance(original, place_signature(samples, turn_rad)), 1e-3);
  }
}

TEST(PlaceSignature, HasUnitLength) {
  const PlaceSignature signature =
      place_signature(samples_from(testing::l_shaped_room(), {2.0, 3.0, 0.4}), 0.4);
  EXPECT_NEAR(signature_distance(signature, PlaceSignature{}), 1.0, 1e-5);
  // Where nothing is seen it is all zero, and not NaN.
  EXPECT_EQ(signature_distance(place_signature({}, 0.0), PlaceSignature{}), 0.0);
}

TEST(PlaceSignature, OneRoomFromTwoPlacesIsMoreAlikeThanTwoRooms) {
  std::mt19937_64 generator = testing::make_generator();
  std::vector<testing::FurnishedRoom> rooms;
  for (int room = 0; room < 12; ++room) rooms.push_back(testing::furnished_room(generator));
  std::vector<PlaceSignature> known;
  for (const auto& room : rooms) {
    const Pose2 pose = testing::free_pose(room, generator);
    known.push_back(place_signature(samples_from(room.walls, pose), pose.theta_rad));
  }
  std::size_t num_among_three = 0;
  for (std::size_t room = 0; room < rooms.size(); ++room) {
    const Pose2 pose = testing::free_pose(rooms[room], generator);
    const auto nearest = nearest_signatures(
        place_signature(samples_from(rooms[room].walls, pose), pose.theta_rad), known, 3);
    num_among_three += std::find(nearest.begin(), nearest.end(), room) != nearest.end() ? 1 : 0;
  }
  // By chance three of twelve would be.
  EXPECT_GE(num_among_three, 7U);
}

TEST(NearestSignatures, AreTheFirstOfAllInOrder) {
  std::mt19937_64 generator = testing::make_generator();
  std::vector<PlaceSignature> among;
  for (int k = 0; k < 300; ++k) among.push_back(random_signature(generator));
  among.push_back(among.front());  // Equal distances: the lower index first.
  const PlaceSignature query = random_signature(generator);
  std::vector<std::size_t> all(among.size());
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
  std::stable_sort(all.begin(), all.end(), [&](std::size_t a, std::size_t b) {
    return signature_distance(query, among[a]) < signature_distance(query, among[b]);
  });
  for (const std::size_t num : {0U, 1U, 12U, 301U, 400U}) {
    const auto nearest = nearest_signatures(query, among, num);
    const std::vector<std::size_t> expected(
        all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(num, 301)));
    EXPECT_EQ(nearest, expected);
  }
}

}  // namespace setsquare::place_signature_test
