// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/live/ros2_messages.hpp"

#include "setsquare/io/logs/bag/scan_messages.hpp"

namespace setsquare::live_app {
namespace {

ros::PoseStamped pose_stamped(Timestamp stamp, const std::string& frame, const Pose2& pose) {
  ros::PoseStamped message;
  message.stamp = stamp;
  message.frame_id = frame;
  message.position_m = {pose.x_m, pose.y_m, 0.0};
  message.orientation = quaternion_from_yaw(pose.theta_rad);
  return message;
}

}  // namespace

ros::PoseWithCovarianceStamped pose_message(const LivePose& pose, const FrameNames& frames) {
  ros::PoseWithCovarianceStamped message;
  static_cast<ros::PoseStamped&>(message) = pose_stamped(pose.stamp, frames.map, pose.T_map_base);
  constexpr std::size_t kOfPlane[] = {0, 1, 5};  // x, y, turn about z among six
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      message.covariance[6 * kOfPlane[row] + kOfPlane[column]] = pose.covariance(row, column);
    }
  }
  return message;
}

ros::TfMessage transforms_message(const LivePose& pose, const FrameNames& frames, bool has_wheels) {
  ros::TfMessage message;
  if (pose.is_placed) {
    message.transforms.push_back(
        transform_from_pose(pose.stamp, frames.map, frames.odom, pose.T_map_odom));
  }
  if (!has_wheels) {
    message.transforms.push_back(
        transform_from_pose(pose.stamp, frames.odom, frames.base, pose.T_odom_base));
  }
  return message;
}

ros::Path path_message(const Trajectory& way, const FrameNames& frames) {
  ros::Path path;
  path.frame_id = frames.map;
  for (const StampedPose& at : way) {
    path.poses.push_back(pose_stamped(at.stamp, frames.map, at.pose));
  }
  if (!way.empty()) path.stamp = way.back().stamp;
  return path;
}

}  // namespace setsquare::live_app
