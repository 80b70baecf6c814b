// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/sensing/robot_path.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "setsquare/core/error.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::testing::robot_path_test {

using Route = std::vector<Eigen::Vector2d>;

double distance_m(const Pose2& a, const Pose2& b) {
  return (a.translation() - b.translation()).norm();
}

/// Waypoints with short pieces, reversals, straight waypoints and repeats among them.
Route random_route(std::mt19937_64& generator) {
  Route route_m{{uniform(generator, -5, 5), uniform(generator, -5, 5)}};
  double heading_rad = 0.0;
  for (int i = 0; i < 30; ++i) {
    const double lot = uniform(generator, 0.0, 1.0);
    if (lot < 0.5) heading_rad += 0.5 * kPi;
    if (lot > 0.5 && lot < 0.8) heading_rad += uniform(generator, -kPi, kPi);
    if (lot > 0.8 && lot < 0.9) heading_rad += kPi;
    const double length_m = lot > 0.95 ? 0.0 : std::pow(10.0, uniform(generator, -1.5, 1.2));
    route_m.push_back(route_m.back() +
                      length_m * Eigen::Vector2d(std::cos(heading_rad), std::sin(heading_rad)));
  }
  return route_m;
}

TEST(RobotPathTest, StraightOnAtDriveSpeed) {
  const RobotPath path({{1.0, 2.0}, {1.0, 5.0}}, {.drive_m_per_s = 0.5});
  EXPECT_DOUBLE_EQ(path.length_m(), 3.0);
  EXPECT_DOUBLE_EQ(path.duration_s(), 6.0);
  EXPECT_THAT(path.pose_at(2.0), PoseNear(Pose2{1.0, 3.0, 0.5 * kPi}, PoseTolerance{}));
  EXPECT_THAT(path.pose_at(-1.0), PoseNear(Pose2{1.0, 2.0, 0.5 * kPi}, PoseTolerance{}));
  EXPECT_THAT(path.pose_at(99.0), PoseNear(Pose2{1.0, 5.0, 0.5 * kPi}, PoseTolerance{}));
}

TEST(RobotPathTest, ACornerIsAnArcOfTheRadius) {
  const RobotPath path({{0, 0}, {5, 0}, {5, 5}}, {.drive_m_per_s = 1.0, .turn_rad_per_s = 4.0});
  // Drives 0.4 m less on both sides and a quarter of a circle of 0.4 m instead.
  EXPECT_NEAR(path.length_m(), 10.0 - 0.8 + 0.4 * 0.5 * kPi, 1e-12);
  EXPECT_NEAR(path.duration_s(), path.length_m(), 1e-12);
  for (double share = 0.0; share <= 1.0; share += 0.125) {
    const Pose2 pose = path.pose_at(4.6 + share * 0.4 * 0.5 * kPi);
    EXPECT_NEAR((pose.translation() - Eigen::Vector2d(4.6, 0.4)).norm(), 0.4, 1e-12);
    EXPECT_NEAR(pose.theta_rad, share * 0.5 * kPi, 1e-12);
  }
}

TEST(RobotPathTest, TurnsNoFasterThanItMayInCorners) {
  const RobotPath path({{0, 0}, {5, 0}, {5, 5}}, {.drive_m_per_s = 1.0, .turn_rad_per_s = 0.5});
  EXPECT_NEAR(path.duration_s(), 9.2 + 0.5 * kPi / 0.5, 1e-12);
}

TEST(RobotPathTest, TurnsInPlaceWhereTheRouteReverses) {
  const RobotPath path({{0, 0}, {2, 0}, {1, 0}}, {.drive_m_per_s = 1.0, .turn_rad_per_s = 0.5});
  EXPECT_NEAR(path.duration_s(), 3.0 + kPi / 0.5, 1e-12);
  EXPECT_NEAR(path.length_m(), 3.0, 1e-12);
  const Pose2 turning = path.pose_at(2.0 + 1.0);
  EXPECT_THAT(turning,
              PoseNear(Pose2{2.0, 0.0, std::copysign(0.5, turning.theta_rad)}, PoseTolerance{}));
  EXPECT_THAT(path.pose_at(99.0), PoseNear(Pose2{1.0, 0.0, -kPi}, PoseTolerance{}));
}

TEST(RobotPathTest, PoseIsContinuousAndHeadingIsThatOfMotion) {
  auto generator = make_generator();
  for (int trial = 0; trial < 20; ++trial) {
    const RobotSpeed speed{.drive_m_per_s = uniform(generator, 0.2, 2.0),
                           .turn_rad_per_s = uniform(generator, 0.2, 2.0),
                           .corner_radius_m = trial % 4 == 0 ? 0.0 : uniform(generator, 0.1, 2.0)};
    const Route route_m = random_route(generator);
    const RobotPath path(route_m, speed);
    EXPECT_NEAR(
        distance_m(path.pose_at(0.0), {route_m.front().x(), route_m.front().y(), 0}), 0, 1e-9);
    EXPECT_NEAR(
        distance_m(path.pose_at(1e9), {route_m.back().x(), route_m.back().y(), 0}), 0, 1e-9);
    constexpr double kStep_s = 1e-3;
    double driven_m = 0.0;
    for (double time_s = 0.0; time_s < path.duration_s(); time_s += kStep_s) {
      const Pose2 now = path.pose_at(time_s);
      const Pose2 next = path.pose_at(time_s + kStep_s);
      const double moved_m = distance_m(now, next);
      const double turned_rad = wrap_to_pi(next.theta_rad - now.theta_rad);
      driven_m += moved_m;
      ASSERT_LE(moved_m, speed.drive_m_per_s * kStep_s * (1.0 + 1e-6)) << time_s;
      ASSERT_LE(std::abs(turned_rad), speed.turn_rad_per_s * kStep_s * (1.0 + 1e-6)) << time_s;
      const Eigen::Vector2d motion = next.translation() - now.translation();
      const double middle_rad = now.theta_rad + 0.5 * turned_rad;
      const double aside_m = std::cos(middle_rad) * motion.y() - std::sin(middle_rad) * motion.x();
      ASSERT_NEAR(aside_m, 0.0, 1e-2 * speed.drive_m_per_s * kStep_s) << time_s;
      ASSERT_GE(motion.dot(Eigen::Vector2d(std::cos(middle_rad), std::sin(middle_rad))), -1e-9);
    }
    EXPECT_NEAR(driven_m, path.length_m(), 1e-4 * path.length_m() + 2 * kStep_s);
  }
}

TEST(RobotPathTest, ArcsMayTakeAShortPieceWhole) {
  // Both arcs want more than half of the middle piece: nothing straight is left between them, and
  // the heading of the moment where they meet is not that of what rounding leaves.
  auto generator = make_generator();
  for (int trial = 0; trial < 200; ++trial) {
    const Pose2 T_map_route{uniform(generator, -5, 5), uniform(generator, -5, 5), 0.1 * trial};
    const double length_m = uniform(generator, 0.1, 0.7);
    Route route_m{{-0.5, 0.0}, {0.0, 0.0}, {0.0, length_m}, {0.5, length_m}};
    for (Eigen::Vector2d& waypoint_m : route_m) waypoint_m = T_map_route * waypoint_m;
    const RobotPath path(route_m);
    double time_s = path.time_at_route_distance(0.5 + 0.5 * length_m);
    for (int i = 0; i < 4; ++i) time_s = std::nextafter(time_s, 0.0);
    for (int i = 0; i < 8; ++i, time_s = std::nextafter(time_s, 1e9)) {
      const double turned_rad = path.pose_at(time_s).theta_rad - T_map_route.theta_rad;
      ASSERT_NEAR(wrap_to_pi(turned_rad), 0.5 * kPi, 1e-9);
    }
  }
}

TEST(RobotPathTest, FindsTheTimeOfAPlaceOfTheRoute) {
  const RobotPath path({{0, 0}, {5, 0}, {5, 5}, {5, 0}});
  for (const double along_m : {0.0, 1.0, 4.5}) {
    EXPECT_NEAR(path.pose_at(path.time_at_route_distance(along_m)).x_m, along_m, 1e-12);
  }
  EXPECT_NEAR(path.pose_at(path.time_at_route_distance(5.0)).theta_rad, 0.25 * kPi, 1e-9);
  EXPECT_NEAR(path.pose_at(path.time_at_route_distance(7.0)).y_m, 2.0, 1e-12);
  EXPECT_NEAR(path.pose_at(path.time_at_route_distance(13.0)).y_m, 2.0, 1e-9);
  EXPECT_NEAR(path.pose_at(path.time_at_route_distance(10.0)).theta_rad, 0.5 * kPi, 1e-12);
  EXPECT_EQ(path.time_at_route_distance(-1.0), 0.0);
  EXPECT_EQ(path.time_at_route_distance(99.0), path.duration_s());
}

TEST(RobotPathTest, StandsAtASinglePointAndRefusesNone) {
  const RobotPath path({{3.0, 4.0}, {3.0, 4.0}});
  EXPECT_EQ(path.duration_s(), 0.0);
  EXPECT_EQ(path.length_m(), 0.0);
  EXPECT_EQ(path.pose_at(5.0), (Pose2{3.0, 4.0, 0.0}));
  EXPECT_THAT(sample_times(path, 0.4, 0.1), ::testing::ElementsAre(0.0));
  EXPECT_THROW(RobotPath(Route{}), ParameterError);
  EXPECT_THROW(RobotPath({{std::numeric_limits<double>::quiet_NaN(), 0.0}}), ParameterError);
  EXPECT_THROW(RobotPath({{0, 0}, {1, 0}}, {.drive_m_per_s = 0.0}), ParameterError);
}

TEST(SampleTimesTest, SamplesAreOneStepApartInDistanceOrAngle) {
  auto generator = make_generator();
  const double angle_rad = rad_from_deg(10.0);
  for (int trial = 0; trial < 20; ++trial) {
    const RobotPath path(random_route(generator));
    const std::vector<double> times_s = sample_times(path, 0.4, angle_rad);
    ASSERT_GT(times_s.size(), 10u);
    EXPECT_EQ(times_s.front(), 0.0);
    for (std::size_t i = 1; i < times_s.size(); ++i) {
      const Pose2 last = path.pose_at(times_s[i - 1]);
      const Pose2 now = path.pose_at(times_s[i]);
      const double distance_share = distance_m(last, now) / 0.4;
      const double angle_share = std::abs(wrap_to_pi(now.theta_rad - last.theta_rad)) / angle_rad;
      EXPECT_NEAR(std::max(distance_share, angle_share), 1.0, 1e-6);
    }
    EXPECT_LT(distance_m(path.pose_at(times_s.back()), path.pose_at(1e9)), 0.4 + 1e-6);
  }
  EXPECT_THROW(static_cast<void>(sample_times(RobotPath({{0, 0}}), 0.0, 1.0)), ParameterError);
  EXPECT_THROW(static_cast<void>(sample_times(RobotPath({{0, 0}}), 1.0, 0.0)), ParameterError);
}

TEST(RobotPathTest, BeforeItDrivesOffItTurnsOnTheSpot) {
  const double rate = rad_from_deg(90.0);
  const RobotPath path({{1.0, 2.0}, {1.0, 5.0}},
                       {.drive_m_per_s = 0.5, .turn_rad_per_s = rate},
                       {.turn_rad = kTwoPi, .rest_s = 1.0});
  EXPECT_NEAR(path.duration_s(), 1.0 + 4.0 + 1.0 + 6.0, 1e-9);
  EXPECT_DOUBLE_EQ(path.length_m(), 3.0);
  for (const auto& [time_s, turned_deg] :
       {std::pair{0.5, 0.0}, {2.0, 90.0}, {4.0, 270.0}, {5.0, 360.0}, {5.9, 360.0}}) {
    const Pose2 expected{1.0, 2.0, wrap_to_pi(0.5 * kPi + rad_from_deg(turned_deg))};
    EXPECT_THAT(path.pose_at(time_s), PoseNear(expected, PoseTolerance{})) << time_s;
  }
  EXPECT_THAT(path.pose_at(8.0), PoseNear(Pose2{1.0, 3.0, 0.5 * kPi}, PoseTolerance{}));
  EXPECT_THROW(RobotPath({{0, 0}, {1, 0}}, {}, {.turn_rad = 1.0, .rest_s = -1.0}), ParameterError);
}

}  // namespace setsquare::testing::robot_path_test
