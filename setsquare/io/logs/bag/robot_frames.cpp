// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/bag/robot_frames.hpp"

#include <algorithm>
#include <iterator>

namespace setsquare {
namespace {

/// Frames of robots, the likelier first, and frames in which robots move (REP 105).
constexpr std::string_view kBaseFrames[] = {"base_link", "base_footprint", "base"};
constexpr std::string_view kOdometryFrames[] = {"odom", "odom_combined"};
constexpr std::string_view kWorldFrames[] = {"odom", "odom_combined", "map", "world", "earth"};

template <typename Names>
bool is_one_of(const Names& names, std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

bool is_in_odometry(const ros::TransformStamped& transform) {
  return is_one_of(kOdometryFrames, ros::plain_frame_name(transform.frame_id));
}

}  // namespace

bool RobotFrames::must_go_on(const ros::TransformStamped& transform) const {
  return is_in_odometry(transform) || tree_.is_held(transform.child_frame_id);
}

bool RobotFrames::is_odometry(const ros::TransformStamped& transform, Timestamp log_time) {
  if (!is_in_odometry(transform)) return false;
  const std::string_view child = ros::plain_frame_name(transform.child_frame_id);
  const bool is_better = is_one_of(kBaseFrames, child) && !is_one_of(kBaseFrames, robot_);
  const bool is_silent = seconds_between(last_robot_, log_time) > kSilent_s;
  if (child != robot_ && !robot_.empty() && !is_better && !is_silent) return false;
  robot_ = child;
  last_robot_ = log_time;
  return true;
}

bool RobotFrames::is_known(std::string_view frame) const {
  return is_one_of(kBaseFrames, frame) || !tree_.parent_of(frame).empty();
}

ros::TransformLookup RobotFrames::mounting_of(const std::string& frame,
                                              const std::string& odometry_base,
                                              Timestamp stamp,
                                              double max_outside_s) const {
  if (!odometry_base.empty()) {
    ros::TransformLookup found = tree_.look_up(odometry_base, frame, stamp, max_outside_s);
    if (found.is_found() || found.status == ros::LookupStatus::kOutsideOfTime) return found;
  }
  const std::string nearest = base_frame_of(frame);
  ros::TransformLookup found = tree_.look_up(nearest, frame, stamp, max_outside_s);
  if (nearest == frame && !is_known(frame)) {
    found.status = ros::LookupStatus::kUnknownFrame;
    found.reason = frame + " is in no transform";
  }
  return found;
}

std::string RobotFrames::base_frame_of(const std::string& frame) const {
  std::string_view topmost = frame;
  for (std::size_t step = 0; step <= ros::TransformTree::kMaxFrames; ++step) {
    if (is_one_of(kBaseFrames, topmost)) break;
    const std::string_view parent = tree_.parent_of(topmost);
    if (parent.empty() || is_one_of(kWorldFrames, parent)) break;
    topmost = parent;
  }
  return std::string(topmost);
}

void RobotFrames::add_placed(const std::string& frame,
                             const std::string& odometry_base,
                             const Eigen::Isometry3d& T_base_sensor) {
  Standing& standing = standing_[frame];
  if (standing.T_base_sensor != T_base_sensor.matrix()) {
    standing = {.T_base_sensor = T_base_sensor.matrix()};
  }
  if (++standing.num_scans != kNumScansToHold) return;
  tree_.hold(odometry_base, frame);
  tree_.hold(base_frame_of(frame), frame);
}

}  // namespace setsquare
