// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/motion_uncertainty.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/core/parameter_checks.hpp"

namespace setsquare {
namespace {

/// Off by so much (sigma) a heading may be any, and the sensor anywhere on its circle.
constexpr double kAnyTurn_rad = 2.0;

/// A sum of sigma u u^T, made no larger than a building.
Eigen::Matrix2d bounded(const Eigen::Matrix2d& open_sigma_m) {
  return open_sigma_m * std::min(1.0, kLargestOpenSigma_m / open_sigma_m.trace());
}

}  // namespace

void MotionUncertaintyParams::validate() const {
  require_positive(step_sigma_m, "step_sigma_m");
  require_positive(step_sigma_rad, "step_sigma_rad");
  require_not_negative(sigma_per_metre, "sigma_per_metre");
  require_not_negative(sigma_per_turn, "sigma_per_turn");
  require_not_negative(scan_sigma_rad, "scan_sigma_rad");
  require_not_negative(open_acceleration_m_per_s2, "open_acceleration_m_per_s2");
  require_not_negative(open_speed_m_per_s, "open_speed_m_per_s");
  require_not_negative(open_sigma_per_metre_by_odometry, "open_sigma_per_metre_by_odometry");
  require_not_negative(open_turn_rad_per_s2, "open_turn_rad_per_s2");
  require_not_negative(open_turn_rad_per_s, "open_turn_rad_per_s");
  require_not_negative(open_sigma_per_turn_by_odometry, "open_sigma_per_turn_by_odometry");
  require_not_negative(open_turn_rad_per_metre_by_odometry, "open_turn_rad_per_metre_by_odometry");
  require_positive(lost_sigma_m, "lost_sigma_m");
  require_positive(lost_sigma_rad, "lost_sigma_rad");
  require_positive(lost_sigma_m_by_odometry, "lost_sigma_m_by_odometry");
  require_positive(lost_sigma_rad_by_odometry, "lost_sigma_rad_by_odometry");
  require_positive(recovered_sigma_m, "recovered_sigma_m");
  require_positive(recovered_sigma_rad, "recovered_sigma_rad");
  require_positive(restart_sigma_m, "restart_sigma_m");
  require_positive(restart_sigma_rad, "restart_sigma_rad");
  require_positive(restart_sigma_m_by_odometry, "restart_sigma_m_by_odometry");
  require_positive(restart_sigma_rad_by_odometry, "restart_sigma_rad_by_odometry");
}

double MotionUncertainty::open_sigma_m(const TrackedPose& tracked, double seconds) {
  if (tracked.has_odometry) {
    const double way_m = (tracked.T_odom_body.translation() - T_odom_last_.translation()).norm();
    return params_.open_sigma_per_metre_by_odometry * way_m;
  }
  // The estimate's own way tells nothing: a robot that stood may have driven on.
  const double open_share = 1.0 - tracked.open_bound_share;
  open_s_ = open_share * (open_s_ + seconds);
  return open_share *
         std::min(params_.open_acceleration_m_per_s2 * open_s_, params_.open_speed_m_per_s) *
         seconds;
}

double MotionUncertainty::open_turn_rad(const TrackedPose& tracked, double seconds) {
  if (tracked.has_odometry) {
    const Pose2 moved = T_odom_last_.inverse() * tracked.T_odom_body;
    const double share =
        std::max(params_.open_sigma_per_turn_by_odometry, tracked.odometry_turn_deviation);
    return share * std::abs(moved.theta_rad) +
           params_.open_turn_rad_per_metre_by_odometry * std::hypot(moved.x_m, moved.y_m);
  }
  const double open_share = 1.0 - tracked.turn_bound_share;
  turn_.seconds = open_share * (turn_.seconds + seconds);
  return open_share *
         std::min(params_.open_turn_rad_per_s2 * turn_.seconds, params_.open_turn_rad_per_s) *
         seconds;
}

double MotionUncertainty::add_open_turn(const TrackedPose& tracked, double seconds) {
  turn_.step_rad = 0.0;
  if (tracked.turn_bound_share < 1.0) {
    if (has_last_) {
      turn_.step_rad = std::min(open_turn_rad(tracked, seconds), kAnyTurn_rad - turn_.sum_rad);
    }
    turn_.sum_rad += turn_.step_rad;
  } else if (tracked.status != TrackStatus::kLost) {
    turn_ = {};
  }
  return turn_.step_rad * tracked.turn_motion_m.norm();
}

double MotionUncertainty::add(const TrackedPose& tracked, const SweepStart& sweep) {
  if (tracked.is_same_again) return 0.0;  // The time until the next new scan goes on.
  double open_m = 0.0;
  const double seconds =
      has_last_ ? std::max(0.0, seconds_between(last_sweep_.stamp, sweep.stamp)) : 0.0;
  if (tracked.status == TrackStatus::kTracked) {
    if (open_s_ > 0.0) ++open_stretch_;
    open_s_ = 0.0;
  }
  const double turned_m = add_open_turn(tracked, seconds);
  has_odometry_ = has_odometry_ && tracked.has_odometry;
  const auto add_jump = [&](double sigma_m, double sigma_rad) {
    jump_variance_m2_ += sigma_m * sigma_m;
    jump_variance_rad2_ += sigma_rad * sigma_rad;
  };
  switch (tracked.status) {
    case TrackStatus::kTracked:
      break;
    case TrackStatus::kDegenerate: {
      if (!has_last_) break;
      const Eigen::Vector2d& u = tracked.open.direction;
      // Errors of successive scans are correlated: sigmas add up, not variances.
      open_m = std::min(std::max(open_sigma_m(tracked, seconds), tracked.open_sigma_m),
                        kLargestOpenSigma_m);
      (tracked.has_odometry ? open_sigma_by_odometry_m_ : open_sigma_m_) +=
          open_m * u * u.transpose();
      break;
    }
    case TrackStatus::kRecovered:
      add_jump(params_.recovered_sigma_m, params_.recovered_sigma_rad);
      break;
    case TrackStatus::kLost:
      if (is_bridged(sweep.scanner) || tracked.sees_nothing_new) break;
      if (tracked.has_odometry) {
        add_jump(params_.lost_sigma_m_by_odometry, params_.lost_sigma_rad_by_odometry);
      } else {
        add_jump(params_.lost_sigma_m, params_.lost_sigma_rad);
      }
      break;
  }
  const StepReach& departure = tracked.departure;
  departure_variance_m2_ += departure.distance_m * departure.distance_m;
  departure_variance_rad2_ += departure.turn_rad * departure.turn_rad;
  if (tracked.is_restart && has_odometry_) {
    add_jump(params_.restart_sigma_m_by_odometry, params_.restart_sigma_rad_by_odometry);
  } else if (tracked.is_restart) {
    add_jump(params_.restart_sigma_m, params_.restart_sigma_rad);
  }
  is_long_step_ = tracked.is_long_step;
  T_odom_last_ = tracked.T_odom_body;
  was_lost_ = tracked.status == TrackStatus::kLost;
  last_sweep_ = sweep;
  has_last_ = true;
  return tracked.turn_bound_share < 1.0 ? turned_m : open_m;
}

MotionCovariance MotionUncertainty::take(double share_of_step) {
  const Pose2 moved = T_odom_keyframe_.inverse() * T_odom_last_;
  const double sigma_m =
      params_.step_sigma_m + params_.sigma_per_metre * std::hypot(moved.x_m, moved.y_m);
  const double sigma_rad =
      params_.step_sigma_rad + params_.sigma_per_turn * std::abs(moved.theta_rad);
  open_sigma_m_ = bounded(open_sigma_m_);
  open_sigma_by_odometry_m_ = bounded(open_sigma_by_odometry_m_);
  const Eigen::Matrix2d open_m2 =
      open_sigma_m_ * open_sigma_m_ + open_sigma_by_odometry_m_ * open_sigma_by_odometry_m_;
  MotionCovariance covariance;
  covariance.translation_m2 =
      (share_of_step * sigma_m * sigma_m + jump_variance_m2_) * Eigen::Matrix2d::Identity() +
      open_m2;
  covariance.open_sigma_m = open_sigma_m_;
  covariance.open_stretch = open_stretch_;
  covariance.rotation_rad2 = share_of_step * sigma_rad * sigma_rad + jump_variance_rad2_;
  covariance.has_odometry = has_odometry_;
  covariance.is_long_step = is_long_step_;
  covariance.slip_sigma_m = std::sqrt(jump_variance_m2_ + open_m2.trace());
  covariance.departure_sigma_m = std::sqrt(departure_variance_m2_);
  covariance.departure_sigma_rad = std::sqrt(departure_variance_rad2_);
  T_odom_keyframe_ = T_odom_last_;
  open_sigma_m_.setZero();
  open_sigma_by_odometry_m_.setZero();
  jump_variance_m2_ = 0.0;
  jump_variance_rad2_ = 0.0;
  departure_variance_m2_ = 0.0;
  departure_variance_rad2_ = 0.0;
  has_odometry_ = true;
  return covariance;
}

}  // namespace setsquare
