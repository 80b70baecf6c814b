// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/sensing/odometry_model.hpp"

#include <cmath>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"

namespace setsquare {

void OdometryParams::validate() const {
  const auto require = [](double value, const char* name) {
    if (!std::isfinite(value) || value < 0.0) {
      throw ParameterError(name, "must be finite and not negative");
    }
  };
  require(distance_scale, "distance_scale");
  require(turn_scale, "turn_scale");
  require(turn_bias_rad_per_m, "turn_bias_rad_per_m");
  require(distance_noise_m_per_sqrt_m, "distance_noise_m_per_sqrt_m");
  require(turn_noise_rad_per_sqrt_rad, "turn_noise_rad_per_sqrt_rad");
  require(turn_noise_rad_per_sqrt_m, "turn_noise_rad_per_sqrt_m");
}

OdometryParams without_drift() { return {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}; }

OdometryModel::OdometryModel(const OdometryParams& params, std::uint64_t seed)
    : params_(params), random_(seed) {
  params_.validate();
  distance_factor_ = 1.0 + params_.distance_scale * random_.normal();
  turn_factor_ = 1.0 + params_.turn_scale * random_.normal();
  turn_bias_rad_per_m_ = params_.turn_bias_rad_per_m * random_.normal();
}

Pose2 OdometryModel::move_to(const Pose2& T_map_base) {
  const Pose2 moved = T_map_last_ ? T_map_last_->inverse() * T_map_base : Pose2{};
  T_map_last_ = T_map_base;
  const double distance_m = std::hypot(moved.x_m, moved.y_m);
  const double turn_rad = moved.theta_rad;
  const double slip_m = params_.distance_noise_m_per_sqrt_m * std::sqrt(distance_m);
  const double slip_rad =
      std::hypot(params_.turn_noise_rad_per_sqrt_rad * std::sqrt(std::abs(turn_rad)),
                 params_.turn_noise_rad_per_sqrt_m * std::sqrt(distance_m));
  const double measured_m = distance_factor_ * distance_m + slip_m * random_.normal();
  const double measured_rad =
      turn_factor_ * turn_rad + turn_bias_rad_per_m_ * distance_m + slip_rad * random_.normal();
  // The chord of an arc lies at half its turn: an arc measured too strongly bent turns its chord.
  const double chord_rad = std::atan2(moved.y_m, moved.x_m) + 0.5 * (measured_rad - turn_rad);
  T_odom_base_ =
      T_odom_base_ *
      Pose2{measured_m * std::cos(chord_rad), measured_m * std::sin(chord_rad), measured_rad};
  return T_odom_base_;
}

}  // namespace setsquare
