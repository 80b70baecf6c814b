// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/slam/motion_uncertainty.hpp"

#include <cmath>

#include "setsquare/core/error.hpp"

namespace setsquare {

void MotionUncertaintyParams::validate() const {
  if (!(step_sigma_m > 0.0)) throw ParameterError("step_sigma_m", "must be positive");
  if (!(step_sigma_rad > 0.0)) throw ParameterError("step_sigma_rad", "must be positive");
  if (!(sigma_per_metre >= 0.0)) throw ParameterError("sigma_per_metre", "must not be negative");
  if (!(restart_sigma_m > 0.0)) throw ParameterError("restart_sigma_m", "must be positive");
}

void MotionUncertainty::add(const TrackedPose& tracked, bool has_odometry) {
  const auto add_jump = [&](double sigma_m, double sigma_rad) {
    jump_variance_m2_ += sigma_m * sigma_m;
    jump_variance_rad2_ += sigma_rad * sigma_rad;
  };
  switch (tracked.status) {
    case TrackStatus::kTracked:
      break;
    case TrackStatus::kDegenerate: {
      const double way_m =
          has_last_ ? (tracked.T_odom_sensor.translation() - T_odom_last_.translation()).norm()
                    : 0.0;
      const double sigma_per_metre =
          has_odometry ? params_.open_sigma_per_metre_by_odometry : params_.open_sigma_per_metre;
      const Eigen::Vector2d& u = tracked.weak.direction;
      // One scan's error is much like the next one's: sigmas add up, not variances.
      open_sigma_m_ += sigma_per_metre * way_m * u * u.transpose();
      break;
    }
    case TrackStatus::kRecovered:
      add_jump(params_.recovered_sigma_m, params_.recovered_sigma_rad);
      break;
    case TrackStatus::kLost:
      if (has_odometry) {
        add_jump(params_.lost_sigma_m_by_odometry, params_.lost_sigma_rad_by_odometry);
      } else {
        add_jump(params_.lost_sigma_m, params_.lost_sigma_rad);
      }
      break;
  }
  if (tracked.is_restart && has_odometry) {
    add_jump(params_.restart_sigma_m_by_odometry, params_.restart_sigma_rad_by_odometry);
  } else if (tracked.is_restart) {
    add_jump(params_.restart_sigma_m, params_.restart_sigma_rad);
  }
  T_odom_last_ = tracked.T_odom_sensor;
  has_last_ = true;
}

MotionCovariance MotionUncertainty::take() {
  const Pose2 moved = T_odom_keyframe_.inverse() * T_odom_last_;
  const double sigma_m =
      params_.step_sigma_m + params_.sigma_per_metre * std::hypot(moved.x_m, moved.y_m);
  const double sigma_rad =
      params_.step_sigma_rad + params_.sigma_per_turn * std::abs(moved.theta_rad);
  MotionCovariance covariance;
  covariance.translation_m2 =
      (sigma_m * sigma_m + jump_variance_m2_) * Eigen::Matrix2d::Identity() +
      open_sigma_m_ * open_sigma_m_;
  covariance.rotation_rad2 = sigma_rad * sigma_rad + jump_variance_rad2_;
  covariance.slip_sigma_m = std::sqrt(jump_variance_m2_ + (open_sigma_m_ * open_sigma_m_).trace());
  T_odom_keyframe_ = T_odom_last_;
  open_sigma_m_.setZero();
  jump_variance_m2_ = 0.0;
  jump_variance_rad2_ = 0.0;
  return covariance;
}

}  // namespace setsquare
