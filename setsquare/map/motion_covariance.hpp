// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <Eigen/Core>

namespace setsquare {

/// How far a motion, or an open stretch, may be off at most (sigma): no building is larger. Stamps
/// may jump by years.
inline constexpr double kLargestOpenSigma_m = 1000.0;

/// Covariance of a tracked motion: translation in the odom frame, rotation apart.
struct MotionCovariance {
  Eigen::Matrix2d translation_m2 = Eigen::Matrix2d::Zero();  ///< In the odom frame.
  double rotation_rad2 = 0.0;                                ///< Of the turn.
  /// Of translation_m2, what an open direction adds where no odometry tells the way along it: the
  /// sum of sigma u u^T, in m. Until a scan tells the robot's speed that is one error: over the
  /// motions of an open stretch the sigmas add up, not the variances.
  Eigen::Matrix2d open_sigma_m = Eigen::Matrix2d::Zero();
  std::size_t open_stretch = 0;  ///< Counts these stretches.
  /// How far the motion may be off beyond tracking's usual noise: where walls left a direction
  /// open, or scans were lost.
  double slip_sigma_m = 0.0;
  /// How far the motion departs from another witness, odometry that has proved true or the last
  /// scan (TrackedPose::departure), as sigmas: one of the two is wrong. The rest of the covariance
  /// does not count it, for mostly the scans are right.
  double departure_sigma_m = 0.0;
  double departure_sigma_rad = 0.0;  ///< The same of the turn.
  bool has_odometry = true;          ///< Whether odometry predicted every scan of the motion.
  /// Whether steps from scan to scan were usually long then: a log of key frames, a low rate. Where
  /// tracking begins anew at such a step, the scans before and after were taken near each other.
  bool is_long_step = false;
};

}  // namespace setsquare
