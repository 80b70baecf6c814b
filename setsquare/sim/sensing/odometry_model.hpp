// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "setsquare/core/pose2.hpp"
#include "setsquare/sim/random.hpp"

namespace setsquare {

/// Errors of wheel odometry, by default of a decent differential drive. All are standard
/// deviations. The first three are errors of a run, drawn once (wheel radii, wheel base, unequal
/// wheels); the others are noise whose variance grows with the motion, however finely the path is
/// sampled (slip).
struct OdometryParams {
  double distance_scale = 0.02;  ///< Share of the distance.
  double turn_scale = 0.02;      ///< Share of the turns.
  double turn_bias_rad_per_m = 0.002;
  double distance_noise_m_per_sqrt_m = 0.01;
  double turn_noise_rad_per_sqrt_rad = 0.01;
  double turn_noise_rad_per_sqrt_m = 0.005;

  /// Throws ParameterError naming the field that is negative or not finite.
  void validate() const;
};

/// Wheels without errors.
[[nodiscard]] OdometryParams without_drift();

/// What the wheels of a robot report while it moves. The frame odom is the base at the first pose.
class OdometryModel {
 public:
  /// Draws the run's errors. Throws ParameterError.
  OdometryModel(const OdometryParams& params, std::uint64_t seed);

  /// The robot has moved on to T_map_base; returns T_odom_base by the wheels. Between two calls the
  /// robot drives about one arc, forward or backward, or turns on the spot.
  Pose2 move_to(const Pose2& T_map_base);

 private:
  OdometryParams params_;
  Random random_;
  double distance_factor_ = 1.0;
  double turn_factor_ = 1.0;
  double turn_bias_rad_per_m_ = 0.0;
  std::optional<Pose2> T_map_last_;
  Pose2 T_odom_base_;
};

}  // namespace setsquare
