// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A scanner in the hand, with a gyro beside it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "setsquare/map/map.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/seed.hpp"
#include "tests/support/simulated_drive.hpp"

namespace setsquare::mapper_gyro_test {

using testing::between;
using testing::drive;
using testing::Fan;
using testing::l_shaped_room;
using testing::make_generator;
using testing::PoseNear;
using testing::PoseTolerance;
using testing::scans_on_drive;
using testing::uniform;
using testing::way_around_the_room;

constexpr double kScan_s = 0.1;
constexpr double kNoise_m = 0.01;
constexpr Fan kWide{270, rad_from_deg(-135.0), rad_from_deg(1.0)};

/// A walk on which the hand swings the scanner about, by up to 25 deg from scan to scan after a
/// calm beginning: 250 deg/s.
std::vector<Pose2> swinging_walk() {
  auto generator = make_generator();
  std::vector<Pose2> poses = drive(way_around_the_room(), 0.05, rad_from_deg(8.0));
  double swing_rad = 0.0;
  for (std::size_t i = 150; i < poses.size(); ++i) {
    swing_rad += uniform(generator, rad_from_deg(-25.0), rad_from_deg(25.0));
    poses[i].theta_rad = wrap_to_pi(poses[i].theta_rad + swing_rad);
  }
  return poses;
}

/// `shown`: what the gyro shows for a true rate; none where it is empty.
Map map_with(const std::vector<Pose2>& poses, const std::function<double(double)>& shown) {
  const std::vector<Scan> scans = scans_on_drive(l_shaped_room(), poses, kNoise_m, kWide);
  Mapper mapper;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    constexpr int kSamples = 10;
    for (int k = 1; i > 0 && shown && k <= kSamples; ++k) {
      const double turn_rad = wrap_to_pi(poses[i].theta_rad - poses[i - 1].theta_rad);
      // Straight lines between samples: the rate rises and falls, so that a scan's turn is whole.
      const double shape = 1.0 - std::cos(kTwoPi * k / kSamples);
      mapper.add_turn_rate({scans[i - 1].stamp.ns + k * 10'000'000},
                           shown(shape * turn_rad / kScan_s));
    }
    mapper.add(scans[i]);
  }
  return mapper.finish();
}

std::size_t num_not_tracked(const Map& map) {
  std::size_t num = 0;
  for (const MappedScan& scan : map.scans) num += scan.status != TrackStatus::kTracked ? 1 : 0;
  return num;
}

TEST(MapperGyro, HelpsWhereTheHandSwingsFast) {
  const std::vector<Pose2> poses = swinging_walk();
  const Map without = map_with(poses, {});
  const Map with = map_with(poses, [](double rate) { return rate + rad_from_deg(2.0); });
  EXPECT_EQ(with.gyro.verdict, GyroVerdict::kBelieved);
  EXPECT_NEAR(with.gyro.bias_rad_per_s, rad_from_deg(2.0), rad_from_deg(0.3));
  EXPECT_EQ(without.gyro.num_samples, 0U);
  EXPECT_LT(2 * num_not_tracked(with), num_not_tracked(without));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    ASSERT_THAT(between(with.scans[0].T_map_sensor, with.scans[i].T_map_sensor),
                PoseNear(between(poses[0], poses[i]),
                         PoseTolerance{.translation_m = 0.06, .rotation_rad = rad_from_deg(0.7)}))
        << i;
  }
}

TEST(MapperGyro, OneThatLiesChangesNothing) {
  const std::vector<Pose2> poses = swinging_walk();
  const Map without = map_with(poses, {});
  const std::vector<std::function<double(double)>> lies = {
      [](double rate) { return -rate; },
      [](double rate) { return deg_from_rad(rate); },
      [](double) { return 0.0; }};
  for (const auto& lie : lies) {
    const Map with = map_with(poses, lie);
    EXPECT_NE(with.gyro.verdict, GyroVerdict::kBelieved);
    EXPECT_NE(with.gyro.verdict, GyroVerdict::kOpen);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      ASSERT_EQ(with.scans[i].T_map_sensor, without.scans[i].T_map_sensor) << i;
    }
  }
}

}  // namespace setsquare::mapper_gyro_test
