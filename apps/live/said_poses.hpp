// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
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

  /// A message of the topic. What cannot be used is counted, and the first is told on standard
  /// error.
  void take(std::string_view cdr);
  /// Messages that could not be used.
  [[nodiscard]] std::uint64_t num_refused() const { return num_refused_; }

 private:
  /// Why the message is none; empty where it is in message_.
  [[nodiscard]] std::string fault_of(std::string_view cdr);
  /// Why the session does not take the pose of message_; empty where it does.
  [[nodiscard]] std::string refusal();

  LiveSession& session_;
  std::string map_frame_;
  std::atomic<std::uint64_t> num_refused_ = 0;
  std::mutex mutex_;  ///< All below.
  ros::MessageDecoder<ros::PoseWithCovarianceStamped> decoder_;
  ros::PoseWithCovarianceStamped message_;
};

}  // namespace setsquare::live_app
