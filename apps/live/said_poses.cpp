// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/live/said_poses.hpp"

#include <Eigen/Geometry>
#include <iostream>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/io/ros/mounting.hpp"
#include "setsquare/io/ros/transform_tree.hpp"

namespace setsquare::live_app {

SaidPoses::SaidPoses(LiveSession& session, std::string map_frame)
    : session_(session),
      map_frame_(std::move(map_frame)),
      decoder_(MessageTopic{.name = kSaidPoseTopic,
                            .type = plain_type_name(kSaidPoseType),
                            .definition = {},
                            .encoding = MessageEncoding::kCdr}) {}

std::string SaidPoses::fault_of(std::string_view cdr) {
  if (const std::string_view fault = decoder_.decode(cdr, message_); !fault.empty()) {
    return std::string(fault);
  }
  const std::string_view frame = ros::plain_frame_name(message_.frame_id);
  if (!frame.empty() && frame != map_frame_) return "its frame is not that of the map";
  const ros::TransformFault fault = ros::fault_of_pose(message_.position_m, message_.orientation);
  return ros::is_refused(fault) ? std::string(ros::to_text(fault)) : std::string();
}

std::string SaidPoses::refusal() {
  const Eigen::Isometry3d T_map_base = Eigen::Translation3d(message_.position_m) *
                                       Eigen::Isometry3d(message_.orientation.normalized());
  try {
    if (session_.set_pose(ros::planar_pose(T_map_base))) return {};
    return "a pose has no meaning while a map is made";
  } catch (const ParameterError& error) {
    return error.what();
  }
}

void SaidPoses::take(std::string_view cdr) {
  const std::lock_guard lock(mutex_);
  std::string reason = fault_of(cdr);
  if (reason.empty()) reason = refusal();
  if (reason.empty()) return;
  if (num_refused_++ == 0) std::cerr << kSaidPoseTopic << ": left out: " << reason << std::endl;
}

}  // namespace setsquare::live_app
