// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/sweep_refinement.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <iostream>

#include "setsquare/surfaces/alignment.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::sweep_refinement_test {

using testing::uniform;

constexpr double kTolerance_m = 0.1;
constexpr std::size_t kNumBeams = 1081;
constexpr double kStep_rad = rad_from_deg(0.25);
constexpr double kMiddle_rad = 0.0;

/// What a sensor sees that turns by `turn` rad for each rad of bearing, at T in the sweep's middle.
Scan turning_scan(const std::vector<testing::Wall>& walls,
                  const Pose2& T_world_sensor,
                  double turn,
                  std::mt19937_64& generator) {
  std::normal_distribution<double> noise_m(0.0, 0.01);
  Scan scan;
  scan.first_bearing_rad = kMiddle_rad - 0.5 * (kNumBeams - 1) * kStep_rad;
  scan.bearing_step_rad = kStep_rad;
  scan.max_range_m = 30.0;
  for (std::size_t beam = 0; beam < kNumBeams; ++beam) {
    const double bearing_rad = scan.bearing_rad(beam);
    const double heading_rad = T_world_sensor.theta_rad + turn * (bearing_rad - kMiddle_rad);
    scan.ranges_m.push_back(
        testing::cast_ray(
            walls, T_world_sensor.x_m, T_world_sensor.y_m, heading_rad + bearing_rad) +
        noise_m(generator));
  }
  return scan;
}

struct MeanError {
  double translation_m = 0.0;
  double rotation_rad = 0.0;

  void add(const Pose2& found, const Pose2& truth, int num_trials) {
    translation_m += std::hypot(found.x_m - truth.x_m, found.y_m - truth.y_m) / num_trials;
    rotation_rad += std::abs(wrap_to_pi(found.theta_rad - truth.theta_rad)) / num_trials;
  }
};

TEST(SweepRefinement, FindsThePoseAtTheMiddleOfTurningSweeps) {
  auto generator = testing::make_generator();
  constexpr int kNumTrials = 60;
  MeanError rigid_error;
  MeanError error;
  double turn_error = 0.0;
  for (int trial = 0; trial < kNumTrials; ++trial) {
    const auto room = testing::furnished_room(generator);
    const Pose2 T_world_reference = testing::free_pose(room, generator);
    const Pose2 step{uniform(generator, -0.3, 0.3),
                     uniform(generator, -0.3, 0.3),
                     uniform(generator, -1.0, 1.0)};
    const Pose2 T_world_current = T_world_reference * step;
    const SweepTurns turns{uniform(generator, -0.008, 0.008), uniform(generator, -0.008, 0.008)};
    const auto reference =
        prepare(turning_scan(room.walls, T_world_reference, turns.reference, generator));
    const auto current =
        prepare(turning_scan(room.walls, T_world_current, turns.current, generator));
    const Pose2 truth = T_world_reference.inverse() * T_world_current;
    constexpr std::array kTolerances_m{0.2, 0.15, 0.1, 0.1};
    const Pose2 rigid =
        refine(reference.dense_alignment(), current.dense_alignment(), truth, kTolerances_m);
    const SweepRefinement refined =
        refine_with_turns(reference.swept(), current.swept(), rigid, kTolerance_m);
    rigid_error.add(rigid, truth, kNumTrials);
    error.add(refined.T_reference_current, truth, kNumTrials);
    turn_error += 0.5 *
                  (std::abs(refined.turns.reference - turns.reference) +
                   std::abs(refined.turns.current - turns.current)) /
                  kNumTrials;
  }
  std::cout << "rigid " << 1e3 * rigid_error.translation_m << " mm, "
            << deg_from_rad(rigid_error.rotation_rad) << " deg; turns free "
            << 1e3 * error.translation_m << " mm, " << deg_from_rad(error.rotation_rad)
            << " deg; turns off by " << turn_error << "\n";
  EXPECT_LT(error.translation_m, 0.5 * rigid_error.translation_m);
  EXPECT_LT(error.rotation_rad, rigid_error.rotation_rad);
  // A turn that both sweeps share hardly shows where both see the same.
  EXPECT_LT(turn_error, 0.003);
}

TEST(SweepRefinement, OfStandingSensorsFindsNextToNoTurn) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 20; ++trial) {
    const auto room = testing::furnished_room(generator);
    const Pose2 T_world_sensor = testing::free_pose(room, generator);
    const auto look = [&] {
      return prepare(turning_scan(room.walls, T_world_sensor, 0.0, generator));
    };
    const auto reference = look();
    const auto current = look();
    const SweepRefinement refined =
        refine_with_turns(reference.swept(), current.swept(), {}, kTolerance_m);
    EXPECT_THAT(refined.T_reference_current,
                testing::PoseNear(Pose2{}, testing::PoseTolerance{0.01, rad_from_deg(0.2)}));
    EXPECT_NEAR(refined.turns.reference, 0.0, 0.002);
    EXPECT_NEAR(refined.turns.current, 0.0, 0.002);
    // Turns that are free can only leave the pose less firmly held.
    const Eigen::Matrix3d lost = refined.pose_hessian - refined.normal.hessian;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(lost);
    EXPECT_GT(solver.eigenvalues()(0), -1e-6 * refined.pose_hessian.norm());
    EXPECT_GT(solver.eigenvalues()(2), 0.0);
  }
}

}  // namespace setsquare::sweep_refinement_test
