// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <string>
#include <string_view>

#include "setsquare/core/pose2.hpp"
#include "setsquare/io/ros/message_decoder.hpp"
#include "setsquare/live/live_session.hpp"

namespace setsquare::live_app {

/// The topic and its type, as rviz and nav2 have them.
inline constexpr const char* kSaidPoseTopic = "/initialpose";
inline constexpr const char* kSaidPoseType = "geometry_msgs/msg/PoseWithCovarianceStamped";

/// Poses that somebody says the robot has. The session must outlive it. By any thread.
class SaidPoses {
 public:
  /// `map_frame`: in which poses must be given.
  SaidPoses(LiveSession& session, std::string map_frame);

  /// A message of the topic. What cannot be used is told on standard error.
  void take(std::string_view cdr);

 private:
  [[nodiscard]] std::string_view fault_of(std::string_view cdr);

  LiveSession& session_;
  std::string map_frame_;
  std::mutex mutex_;  ///< All below.
  ros::MessageDecoder<ros::PoseWithCovarianceStamped> decoder_;
  ros::PoseWithCovarianceStamped message_;
  bool is_refusal_told_ = false;
};

}  // namespace setsquare::live_app
