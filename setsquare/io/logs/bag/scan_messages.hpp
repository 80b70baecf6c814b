// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Scans and poses of the plane as ROS messages, for all that writes recordings.
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"
#include "setsquare/grid/occupancy_grid.hpp"
#include "setsquare/io/ros/messages.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// The topic of a laser: its own name where that is a topic, else "/scan" for the first and
/// "/scan_NAME" for others.
[[nodiscard]] std::string laser_topic_name(const std::string& sensor, bool is_first);

/// "laser" for "/scan"; else the topic without slashes.
[[nodiscard]] std::string laser_frame_name(const std::string& topic);

/// A rotation about z.
[[nodiscard]] Eigen::Quaterniond quaternion_from_yaw(double yaw_rad);

/// A scan as a message of this frame. Bearings and ranges are as the scan has them.
void laser_scan_from_scan(const Scan& scan, const std::string& frame, ros::LaserScan& message);

/// A transform of the plane as a message.
[[nodiscard]] ros::TransformStamped transform_from_pose(Timestamp stamp,
                                                        const std::string& parent,
                                                        const std::string& child,
                                                        const Pose2& T_parent_child);

/// A grid in the frame that it is told to lie in: 100 where occupied, 0 where free, -1 where
/// unknown.
[[nodiscard]] ros::OccupancyGrid message_from_grid(const OccupancyGrid& grid,
                                                   const std::string& frame,
                                                   Timestamp stamp);

}  // namespace setsquare
