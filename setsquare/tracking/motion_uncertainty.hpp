// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "setsquare/core/angle.hpp"
#include "setsquare/tracking/tracked_pose.hpp"

namespace setsquare {

/// How certain tracked motion between neighbouring keyframes is.
struct MotionUncertaintyParams {
  double step_sigma_m = 0.004;    ///< Of every step ...
  double sigma_per_metre = 0.01;  ///< ... and this share of its length.
  /// Along a direction that the walls left open, the share of the way in which they did.
  double open_sigma_per_metre = 0.3;
  double open_sigma_per_metre_by_odometry = 0.05;  ///< The same where odometry stood in.
  double lost_sigma_m = 0.3;                       ///< Of each lost scan in between.
  double recovered_sigma_m = 0.05;                 ///< Of each scan found again far off.
  double restart_sigma_m = 200.0;                  ///< Of each new start of the submap.

  double step_sigma_rad = rad_from_deg(0.06);  ///< Of every step ...
  double sigma_per_turn = 0.005;               ///< ... and this share of the turn.
  double lost_sigma_rad = 0.05;
  double recovered_sigma_rad = rad_from_deg(1.5);
  double restart_sigma_rad = 0.5;

  // The same where odometry bridges the gap: a witness.
  double lost_sigma_m_by_odometry = 0.03;
  double restart_sigma_m_by_odometry = 0.3;
  double lost_sigma_rad_by_odometry = rad_from_deg(0.5);
  double restart_sigma_rad_by_odometry = rad_from_deg(3.0);

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Covariance of a tracked motion: translation in the odom frame, rotation apart.
struct MotionCovariance {
  Eigen::Matrix2d translation_m2 = Eigen::Matrix2d::Zero();
  double rotation_rad2 = 0.0;
  /// How far the motion may be off beyond tracking's usual noise: where walls left a direction
  /// open, or scans were lost.
  double slip_sigma_m = 0.0;
  bool has_odometry = true;  ///< Whether odometry predicted every scan of the motion.
};

/// Gathers, scan by scan, how uncertain the motion since the last keyframe is.
class MotionUncertainty {
 public:
  explicit MotionUncertainty(const MotionUncertaintyParams& params) : params_(params) {}

  /// The next scan.
  void add(const TrackedPose& tracked);

  /// The covariance of the motion up to the last scan added, which is a keyframe; starts anew.
  [[nodiscard]] MotionCovariance take();

 private:
  MotionUncertaintyParams params_;
  bool has_last_ = false;
  bool has_odometry_ = true;  ///< At every scan since the last keyframe.
  Pose2 T_odom_last_;         ///< Of the last scan ...
  Pose2 T_odom_keyframe_;     ///< ... and of the last keyframe.
  /// Sum of the ways in which a direction was open, each as sigma x u u^T, in m.
  Eigen::Matrix2d open_sigma_m_ = Eigen::Matrix2d::Zero();
  double jump_variance_m2_ = 0.0;
  double jump_variance_rad2_ = 0.0;
};

}  // namespace setsquare
