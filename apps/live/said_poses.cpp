// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/live/said_poses.hpp"

#include <cmath>
#include <Eigen/Geometry>
#include <iostream>
#include <utility>

#include "setsquare/io/ros/mounting.hpp"

namespace setsquare::live_app {

SaidPoses::SaidPoses(LiveSession& session, std::string map_frame)
    : session_(session),
      map_frame_(std::move(map_frame)),
      decoder_(MessageTopic{.name = kSaidPoseTopic,
                            .type = plain_type_name(kSaidPoseType),
                            .definition = {},
                            .encoding = MessageEncoding::kCdr}) {}

std::string_view SaidPoses::fault_of(std::string_view cdr) {
  if (const std::string_view fault = decoder_.decode(cdr, message_); !fault.empty()) return fault;
  std::string_view frame = message_.frame_id;
  if (frame.starts_with('/')) frame.remove_prefix(1);
  if (!frame.empty() && frame != map_frame_) return "its frame is not that of the map";
  if (!message_.position_m.allFinite() || !message_.orientation.coeffs().allFinite() ||
      message_.orientation.norm() < 0.5) {
    return "it is no pose";
  }
  return {};
}

void SaidPoses::take(std::string_view cdr) {
  const std::lock_guard lock(mutex_);
  if (const std::string_view fault = fault_of(cdr); !fault.empty()) {
    if (!is_refusal_told_) std::cerr << kSaidPoseTopic << ": left out: " << fault << std::endl;
    is_refusal_told_ = true;
    return;
  }
  const Eigen::Isometry3d T_map_base = Eigen::Translation3d(message_.position_m) *
                                       Eigen::Isometry3d(message_.orientation.normalized());
  if (session_.set_pose(ros::planar_pose(T_map_base))) return;
  if (!is_refusal_told_) {
    std::cerr << kSaidPoseTopic << " has no meaning while a map is made: left out" << std::endl;
  }
  is_refusal_told_ = true;
}

}  // namespace setsquare::live_app
