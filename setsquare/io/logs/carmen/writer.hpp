// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// The robot's part of a ROBOTLASERn message.
struct CarmenRobot {
  Pose2 T_odom_base;  ///< By the wheels.
  double forward_m_per_s = 0.0;
  double turn_rad_per_s = 0.0;
};

/// Appends a scan as one line of a CARMEN log:
/// "ROBOTLASERn laser_type start_angle field_of_view angular_resolution maximum_range accuracy
/// remission_mode num_ranges [ranges] num_remissions [remissions] laser_x laser_y laser_theta
/// robot_x robot_y robot_theta laser_tv laser_rv forward_safety side_safety turn_axis
/// timestamp host logger_timestamp", both poses by odometry, their difference the mounting; n is
/// Scan::scanner from 1.
/// Ranges in m with three decimals, poses with six, stamps to the microsecond, or to the nanosecond
/// where they have one. What a beam measured (Scan::outcome) survives: a no-return is written as
/// the maximum range, an invalid beam as 0. Throws ParameterError where the scan has no beam or no
/// finite maximum range or is not valid: the format could not state it.
void append_carmen_scan(std::string& log, const Scan& scan, const CarmenRobot& robot);

/// Appends the robot's true pose, as a simulator knows it: "TRUEPOS true_x true_y true_theta odom_x
/// odom_y odom_theta timestamp host logger_timestamp".
void append_carmen_true_pose(std::string& log,
                             Timestamp stamp,
                             const Pose2& T_map_base,
                             const Pose2& T_odom_base);

}  // namespace setsquare
