// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/deskew.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::deskew_test {

using testing::cast_ray;
using testing::empty_rectangle;
using testing::Fan;
using testing::make_generator;
using testing::PoseNear;
using testing::PoseTolerance;
using testing::uniform;
using testing::Wall;

constexpr Fan kFans[] = {{360, -kPi, kTwoPi / 360.0},
                         {360, kPi, -kTwoPi / 360.0},
                         {720, 0.0, kTwoPi / 720.0},
                         {541, rad_from_deg(-135.0), rad_from_deg(0.5)}};

Scan empty_scan(const Fan& fan) {
  Scan scan;
  scan.first_bearing_rad = fan.first_bearing_rad;
  scan.bearing_step_rad = fan.bearing_step_rad;
  scan.max_range_m = 30.0;
  scan.ranges_m.assign(fan.num_beams, 31.0);
  return scan;
}

double range_in(const std::vector<Wall>& room, const Pose2& T_room_sensor, double bearing_rad) {
  return cast_ray(
      room, T_room_sensor.x_m, T_room_sensor.y_m, T_room_sensor.theta_rad + bearing_rad);
}

/// What a sensor measures that moves meanwhile.
Scan swept_scan(const std::vector<Wall>& room,
                const Pose2& T_room_middle,
                const SweepMotion& motion,
                const Fan& fan) {
  Scan scan = empty_scan(fan);
  for (std::size_t beam = 0; beam < fan.num_beams; ++beam) {
    const Pose2 T_room_sensor = T_room_middle * motion.pose_at(sweep_share(beam, fan.num_beams));
    scan.ranges_m[beam] = range_in(room, T_room_sensor, scan.bearing_rad(beam));
  }
  return scan;
}

SweepMotion random_motion(std::mt19937_64& generator, double max_turn_rad) {
  return {{uniform(generator, -0.05, 0.05), uniform(generator, -0.02, 0.02)},
          uniform(generator, -max_turn_rad, max_turn_rad),
          uniform(generator, -max_turn_rad, max_turn_rad)};
}

TEST(Deskew, WithoutMotionTheScanStaysAsItIs) {
  auto generator = make_generator();
  for (const Fan& fan : kFans) {
    Scan scan = empty_scan(fan);
    for (double& range_m : scan.ranges_m) range_m = uniform(generator, -1.0, 40.0);
    scan.ranges_m[7] = std::numeric_limits<double>::infinity();
    const DeskewedScan same = deskewed(scan, {});
    EXPECT_EQ(same.scan.ranges_m, scan.ranges_m);
    ASSERT_EQ(same.share.size(), scan.num_beams());
    EXPECT_EQ(same.share.front(), -1.0F);
    EXPECT_EQ(same.share.back(), 1.0F);
  }
}

/// Wide rooms: 18 deg in half a sweep of 7 Hz are 250 deg/s.
TEST(Deskew, GivesBackTheWallsOfASkewedScan) {
  auto generator = make_generator();
  for (int trial = 0; trial < 200; ++trial) {
    const Fan& fan = kFans[trial % std::size(kFans)];
    const auto room = empty_rectangle(uniform(generator, 3.0, 9.0), uniform(generator, 3.0, 7.0));
    const Pose2 T_room_middle{1.5, 1.5, uniform(generator, -kPi, kPi)};
    const SweepMotion motion = random_motion(generator, rad_from_deg(18.0));
    const DeskewedScan flat = deskewed(swept_scan(room, T_room_middle, motion, fan), motion);
    std::size_t num_seen = 0;
    std::size_t num_wrong = 0;  // A corner of the room may fall between two beams.
    for (std::size_t beam = 0; beam < fan.num_beams; ++beam) {
      if (flat.scan.outcome(beam) != BeamOutcome::kReturn) continue;
      ++num_seen;
      const double expected_m = range_in(room, T_room_middle, flat.scan.bearing_rad(beam));
      num_wrong += std::abs(flat.scan.ranges_m[beam] - expected_m) > 0.002;
    }
    EXPECT_LE(num_wrong, 10U) << trial;
    // What the turn took out of sight: a tenth of 360 deg at most.
    EXPECT_GE(10 * num_seen, 8 * fan.num_beams) << trial;
  }
}

/// The same skew left in is wrong by decimetres: the test above can fail.
TEST(Deskew, ASkewedScanIsWrongWithoutIt) {
  const auto room = empty_rectangle(6.0, 4.0);
  const Pose2 T_room_middle{1.5, 1.5, 0.3};
  const SweepMotion motion{{0.0, 0.0}, rad_from_deg(9.0), rad_from_deg(9.0)};
  const Scan skewed = swept_scan(room, T_room_middle, motion, kFans[0]);
  double worst_m = 0.0;
  for (std::size_t beam = 0; beam < skewed.num_beams(); ++beam) {
    const double expected_m = range_in(room, T_room_middle, skewed.bearing_rad(beam));
    worst_m = std::max(worst_m, std::abs(skewed.ranges_m[beam] - expected_m));
  }
  EXPECT_GT(worst_m, 0.3);
}

/// The slow twin: for each beam of the answer all neighbouring pairs are tried, their returns taken
/// to the middle one by one. The scan shows one wall all around, so that every pair is joined.
std::optional<double> slow_range_m(const Scan& scan, const SweepMotion& motion, std::size_t beam) {
  const auto unit_vector = [](double angle_rad) {
    return Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad));
  };
  const Eigen::Vector2d ray = unit_vector(scan.bearing_rad(beam));
  std::optional<double> best_m;
  double best_share = 2.0;
  const auto point = [&](std::size_t k) -> Eigen::Vector2d {
    return motion.pose_at(sweep_share(k, scan.num_beams())) *
           Eigen::Vector2d(scan.ranges_m[k] * unit_vector(scan.bearing_rad(k)));
  };
  for (std::size_t k = 0; k + 1 < scan.num_beams(); ++k) {
    const Eigen::Vector2d a = point(k);
    const Eigen::Vector2d along = point(k + 1) - a;
    const double cross = ray.x() * along.y() - ray.y() * along.x();
    const double range_m = (a.x() * along.y() - a.y() * along.x()) / cross;
    const double step = (a.x() * ray.y() - a.y() * ray.x()) / cross;
    if (!(range_m > 0.0) || step < 0.0 || step >= 1.0) continue;
    const double share = std::abs(sweep_share(step < 0.5 ? k : k + 1, scan.num_beams()));
    if (share >= best_share) continue;
    best_share = share;
    best_m = range_m;
  }
  return best_m;
}

TEST(Deskew, AgreesWithItsSlowTwin) {
  auto generator = make_generator();
  for (int trial = 0; trial < 40; ++trial) {
    const Fan& fan = kFans[trial % 2];
    Scan scan = empty_scan(fan);
    for (std::size_t beam = 0; beam < fan.num_beams; ++beam) {
      scan.ranges_m[beam] = 3.0 + 0.5 * std::cos(3.0 * scan.bearing_rad(beam) + trial);
    }
    const SweepMotion motion = random_motion(generator, rad_from_deg(15.0));
    const DeskewedScan flat = deskewed(scan, motion);
    int num_different = 0;
    for (std::size_t beam = 0; beam < fan.num_beams; ++beam) {
      const double range_m = flat.scan.ranges_m[beam];
      const auto expected_m = slow_range_m(scan, motion, beam);
      ASSERT_EQ(expected_m.has_value(), !std::isnan(range_m)) << beam;
      num_different += expected_m && std::abs(range_m - *expected_m) > 1e-6;
    }
    // What both ends of the sweep saw from as far away from its middle may be taken from either.
    EXPECT_LE(num_different, 3) << trial;
  }
}

TEST(Deskew, MotionRunsFromTheFirstBeamToTheLast) {
  const Pose2 T_from_to{0.04, 0.01, 0.2};
  const SweepMotion motion = even_motion(T_from_to, 0.1, 0.1);
  EXPECT_THAT(motion.pose_at(-1.0).inverse() * motion.pose_at(1.0),
              PoseNear(T_from_to, PoseTolerance{.translation_m = 1e-9, .rotation_rad = 1e-9}));
  const SweepMotion reversed = even_motion(T_from_to, 0.1, -0.1);
  EXPECT_THAT(
      reversed.pose_at(1.0),
      PoseNear(motion.pose_at(-1.0), PoseTolerance{.translation_m = 1e-9, .rotation_rad = 1e-9}));
  EXPECT_TRUE(even_motion(T_from_to, 0.0, 0.1).is_rest());
  EXPECT_TRUE(even_motion(T_from_to, -0.1, 0.1).is_rest());
}

TEST(Deskew, SweepTimeIsThatOfTheScan) {
  Scan scan = empty_scan(kFans[0]);
  EXPECT_EQ(sweep_time_s(scan), 0.0);
  scan.time_increment_s = -0.1 / 359.0;
  EXPECT_NEAR(sweep_time_s(scan), -0.1, 1e-12);
  scan.ranges_m.resize(1);
  EXPECT_EQ(sweep_time_s(scan), 0.0);
}

}  // namespace setsquare::deskew_test
