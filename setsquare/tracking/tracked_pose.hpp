// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "setsquare/core/pose2.hpp"
#include "setsquare/map/track_status.hpp"
#include "setsquare/tracking/open_direction.hpp"
#include "setsquare/tracking/step_reach.hpp"

namespace setsquare {

/// Where a scan of a scanner whose mounting is not believed would stand, by what it sees.
struct MountingSighting {
  Pose2 T_odom_sensor;   ///< By what it sees, in the odom frame.
  bool is_bound = true;  ///< Whether the walls bind its position in every direction.
};

/// A scan placed by tracking, with its evidence. A separate header, so that users of Mapper need
/// not include the rest of the tracker.
struct TrackedPose {
  TrackStatus status = TrackStatus::kTracked;  ///< How it was placed.
  /// Of its sensor at the middle of its sweep, in the odom frame: smooth, drifts.
  Pose2 T_odom_sensor;
  Pose2 T_odom_body = {};    ///< Of the robot, as tracking follows it: of the first scan's scanner.
  bool is_keyframe = false;  ///< Whether it is kept to match with.
  bool is_mapped = true;     ///< Else the pose is the expected one (MappedScanner).
  bool is_restart = false;   ///< Lost for so long that the submap restarts with this scan.
  bool is_long_step = false;  ///< One of many: a log of key frames, a low rate (LongSteps).
  bool has_odometry = false;  ///< Whether odometry predicted it: its own and the last scan's.
  /// The scan before again, range by range, and no odometry: it stands where that stands, and may
  /// be of another place if a scanner hangs.
  bool is_same_again = false;
  /// The same where odometry tells that the robot moved meanwhile: it is where that has it, lost.
  bool sees_nothing_new = false;
  double score = 1.0;  ///< Share of the points explained by the submap less share contradicted.
  OpenDirection open;  ///< In the odom frame.
  double open_bound_share = 1.0;  ///< How far the walls bind it (SubmapRefinementParams).
  double turn_bound_share = 1.0;  ///< The same of its turn (OpenTurnParams).
  /// Where its turn is open: the sensor's motion, in the odom frame, for a turn by 1 rad that
  /// leaves the scan as it is.
  Eigen::Vector2d turn_motion_m = Eigen::Vector2d::Zero();
  /// How far the odometry's turns are off, as a share of the turn, as it has proved; 0 where
  /// nothing has shown it.
  double odometry_turn_deviation = 0.0;
  /// How far it is from where another witness has it, and turned against that: odometry that has
  /// proved true, unless it is no farther off than usual, or the last scan where it contradicts a
  /// jolt (is_contradicted); else zeros. One of the two is wrong.
  StepReach departure = {};
  /// Spread of the motion along the open direction where nothing tells it: the robot may have gone
  /// as far as it does between scans. 0 where the last motion does.
  double open_sigma_m = 0.0;
};

}  // namespace setsquare
