// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Trajectories for the tests of this folder.
#pragma once

#include <cmath>
#include <random>

#include "setsquare/core/trajectory.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::testing {

inline Timestamp stamp_at(double seconds) { return timestamp_from_seconds(seconds); }

inline Pose2 random_pose(std::mt19937_64& generator) {
  return {uniform(generator, -20.0, 20.0),
          uniform(generator, -20.0, 20.0),
          uniform(generator, -kPi, kPi)};
}

/// A pose within a few centimetres and some tenths of a degree of the identity.
inline Pose2 small_motion(std::mt19937_64& generator,
                          double translation_sigma_m,
                          double rotation_sigma_rad) {
  std::normal_distribution<double> normal;
  const double x_m = translation_sigma_m * normal(generator);
  const double y_m = translation_sigma_m * normal(generator);
  return {x_m, y_m, rotation_sigma_rad * normal(generator)};
}

/// One pose per second, anywhere.
inline Trajectory random_trajectory(std::mt19937_64& generator, int num_poses) {
  Trajectory trajectory;
  for (int i = 0; i < num_poses; ++i) trajectory.push_back({stamp_at(i), random_pose(generator)});
  return trajectory;
}

/// The trajectory in another map frame.
inline Trajectory moved(const Trajectory& trajectory, const Pose2& T_other_map) {
  Trajectory result = trajectory;
  for (StampedPose& stamped : result) stamped.pose = T_other_map * stamped.pose;
  return result;
}

}  // namespace setsquare::testing
