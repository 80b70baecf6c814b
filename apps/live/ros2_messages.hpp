// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What live mapping finds as messages of ROS 2, whoever carries them.
#pragma once

#include <string>

#include "setsquare/core/trajectory.hpp"
#include "setsquare/io/ros/messages.hpp"
#include "setsquare/live/live_pose.hpp"

namespace setsquare::live_app {

/// Names of the frames between which the robot is placed (REP 105).
struct FrameNames {
  std::string map = "map";
  std::string odom = "odom";
  std::string base = "base_link";
};

[[nodiscard]] ros::PoseWithCovarianceStamped pose_message(const LivePose& pose,
                                                          const FrameNames& frames);

/// map -> odom, where the robot's place in the map is known; and odom -> base where the robot has
/// no odometry that tells it.
[[nodiscard]] ros::TfMessage transforms_message(const LivePose& pose,
                                                const FrameNames& frames,
                                                bool has_wheels);

[[nodiscard]] ros::Path path_message(const Trajectory& way, const FrameNames& frames);

}  // namespace setsquare::live_app
