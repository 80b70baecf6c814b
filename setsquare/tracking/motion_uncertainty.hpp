// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <Eigen/Core>

#include "setsquare/core/angle.hpp"
#include "setsquare/map/motion_covariance.hpp"
#include "setsquare/tracking/motion_prediction.hpp"
#include "setsquare/tracking/scan_tracker_params.hpp"
#include "setsquare/tracking/tracked_pose.hpp"

namespace setsquare {

/// Gathers, scan by scan, how uncertain the motion since the last keyframe is.
class MotionUncertainty {
 public:
  explicit MotionUncertainty(const MotionUncertaintyParams& params) : params_(params) {}

  /// The next scan, of one of the robot's scanners. One that is lost right after another scanner's
  /// was not adds nothing: that one saw the motion. Returns how far off the motion from the last
  /// scan may be along the direction that the walls leave open (sigma, m); 0 where they leave none.
  double add(const TrackedPose& tracked, const SweepStart& sweep = {});

  /// How far the last scan's turn from the one before may be off (sigma, rad) where the walls leave
  /// it open: then add() has returned what that turn moves the sensor by. Else 0.
  [[nodiscard]] double open_turn_sigma_rad() const { return turn_.step_rad; }

  /// The covariance of the motion up to the last scan added, which is a keyframe; restarts the sum.
  /// `share_of_step`: where several scanners leave keyframes, each of them is so much of one step;
  /// tracking's usual noise grows with the way, not with the number of scanners.
  [[nodiscard]] MotionCovariance take(double share_of_step = 1.0);

 private:
  [[nodiscard]] bool is_bridged(std::uint32_t scanner) const {
    return has_last_ && scanner != last_sweep_.scanner && !was_lost_;
  }
  /// How far off the motion from the last scan may be along a direction that was open.
  [[nodiscard]] double open_sigma_m(const TrackedPose& tracked, double seconds);
  /// The same of a turn that was open.
  [[nodiscard]] double open_turn_rad(const TrackedPose& tracked, double seconds);
  /// Adds a turn that is open to the run of them, or ends the run. Returns how far it may have
  /// moved the sensor, in m.
  double add_open_turn(const TrackedPose& tracked, double seconds);

  MotionUncertaintyParams params_;
  bool has_last_ = false;
  bool was_lost_ = false;      ///< The last scan ...
  SweepStart last_sweep_;      ///< ... and its scanner.
  bool is_long_step_ = false;  ///< Of the last scan.
  double open_s_ = 0.0;        ///< Since when no scan has told the speed.
  bool has_odometry_ = true;   ///< At every scan since the last keyframe.
  Pose2 T_odom_last_;          ///< Of the body at the last scan ...
  Pose2 T_odom_keyframe_;      ///< ... and at the last keyframe.
  /// Sum of the ways in which a direction was open, each as sigma x u u^T, in m: without odometry
  Eigen::Matrix2d open_sigma_m_ = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d open_sigma_by_odometry_m_ = Eigen::Matrix2d::Zero();  ///< ... and by it.
  std::size_t open_stretch_ = 0;
  double jump_variance_m2_ = 0.0;
  double jump_variance_rad2_ = 0.0;
  double departure_variance_m2_ = 0.0;
  double departure_variance_rad2_ = 0.0;
  /// Scans in a row whose turn is open. Their errors are one error: sigmas add up.
  struct OpenTurnRun {
    double seconds = 0.0;   ///< Since when no scan has told the rate of turn.
    double sum_rad = 0.0;   ///< Of the run.
    double step_rad = 0.0;  ///< Of the last scan.
  } turn_;
};

}  // namespace setsquare
