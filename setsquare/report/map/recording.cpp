// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/recording.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "setsquare/grid/grid_from_scans.hpp"
#include "setsquare/io/logs/bag/scan_messages.hpp"
#include "setsquare/io/ros/builtin_definitions.hpp"
#include "setsquare/io/ros/message_encoder.hpp"
#include "setsquare/report/map/closure_markers.hpp"

namespace setsquare {
namespace {

constexpr const char* kMapFrame = "map";
constexpr const char* kBaseFrame = "base_link";
/// Pictures of the growing map over the whole run: enough to see it grow, few enough to make.
constexpr double kNumPictures = 100.0;
constexpr double kShortestPeriod_s = 1.0;
/// The way and the scans that make the map need not be denser.
constexpr double kSpacing_m = 0.1;
constexpr double kTurn_rad = 0.0873;

std::string definition_of(const std::string& type) {
  return ros::builtin_definition(type, MessageEncoding::kCdr);
}

bool has_moved(const Pose2& from, const Pose2& to) {
  return std::hypot(to.x_m - from.x_m, to.y_m - from.y_m) >= kSpacing_m ||
         std::abs(wrap_to_pi(to.theta_rad - from.theta_rad)) >= kTurn_rad;
}

}  // namespace

MapRecording::MapRecording(McapWriter::Sink sink,
                           Trajectory trajectory,
                           std::vector<LoopClosure> closures)
    : file_(std::move(sink)),
      trajectory_(std::move(trajectory)),
      closures_(std::move(closures)),
      transforms_(
          file_.add_channel("/tf", "tf2_msgs/msg/TFMessage", definition_of("tf2_msgs/TFMessage"))),
      static_transforms_(file_.add_channel(
          "/tf_static", "tf2_msgs/msg/TFMessage", definition_of("tf2_msgs/TFMessage"), true)),
      map_(file_.add_channel(
          "/map", "nav_msgs/msg/OccupancyGrid", definition_of("nav_msgs/OccupancyGrid"), true)),
      path_channel_(
          file_.add_channel("/path", "nav_msgs/msg/Path", definition_of("nav_msgs/Path"))),
      closure_channel_(file_.add_channel(
          "/closures", "visualization_msgs/msg/MarkerArray", closure_marker_definition())) {
  std::stable_sort(trajectory_.begin(),
                   trajectory_.end(),
                   [](const StampedPose& a, const StampedPose& b) { return a.stamp < b.stamp; });
  path_.frame_id = kMapFrame;
  if (trajectory_.empty()) return;
  next_picture_ = trajectory_.front().stamp;
  picture_period_s_ =
      std::max(kShortestPeriod_s,
               seconds_between(trajectory_.front().stamp, trajectory_.back().stamp) / kNumPictures);
}

const Pose2* MapRecording::pose_at(Timestamp stamp) const {
  // Trajectories are written to the microsecond.
  constexpr std::int64_t kMaxDifference_ns = 1000;
  const auto found =
      std::lower_bound(trajectory_.begin(),
                       trajectory_.end(),
                       stamp.ns - kMaxDifference_ns,
                       [](const StampedPose& pose, std::int64_t ns) { return pose.stamp.ns < ns; });
  const bool is_same_moment =
      found != trajectory_.end() && found->stamp.ns <= stamp.ns + kMaxDifference_ns;
  return is_same_moment ? &found->pose : nullptr;
}

MapRecording::LaserTopic& MapRecording::laser_topic(const std::string& topic) {
  const auto [entry, is_new] = lasers_.try_emplace(topic);
  if (is_new) {
    const std::string name = laser_topic_name(topic, lasers_.size() == 1);
    entry->second.frame = laser_frame_name(name);
    entry->second.channel = file_.add_channel(
        name, "sensor_msgs/msg/LaserScan", definition_of("sensor_msgs/LaserScan"));
  }
  return entry->second;
}

bool MapRecording::add(const std::string& topic, const Scan& scan) {
  const Pose2* T_map_base = pose_at(scan.stamp);
  if (T_map_base == nullptr) return false;
  LaserTopic& laser = laser_topic(topic);
  if (!laser.is_placed) {
    laser.is_placed = true;
    const ros::TfMessage place{
        {transform_from_pose(scan.stamp, kBaseFrame, laser.frame, scan.T_base_sensor)}};
    ros::encode(place, cdr_);
    file_.write(static_transforms_, scan.stamp, cdr_.message());
  }
  const ros::TfMessage robot{{transform_from_pose(scan.stamp, kMapFrame, kBaseFrame, *T_map_base)}};
  ros::encode(robot, cdr_);
  file_.write(transforms_, scan.stamp, cdr_.message());
  laser_scan_from_scan(scan, laser.frame, message_);
  ros::encode(message_, cdr_);
  file_.write(laser.channel, scan.stamp, cdr_.message());
  keep_for_map(scan, *T_map_base);
  last_stamp_ = scan.stamp;
  if (scan.stamp >= next_picture_) {
    write_picture(scan.stamp);
    next_picture_ = {scan.stamp.ns + static_cast<std::int64_t>(1e9 * picture_period_s_)};
  }
  return true;
}

void MapRecording::keep_for_map(const Scan& scan, const Pose2& T_map_base) {
  const Pose2 T_map_sensor = T_map_base * scan.T_base_sensor;
  if (!inserted_.empty() && !has_moved(inserted_.back().T_map_sensor, T_map_sensor)) return;
  inserted_.push_back({scan, T_map_sensor});
  ros::PoseStamped pose;
  pose.stamp = scan.stamp;
  pose.frame_id = kMapFrame;
  pose.position_m = {T_map_base.x_m, T_map_base.y_m, 0.0};
  pose.orientation = quaternion_from_yaw(T_map_base.theta_rad);
  path_.poses.push_back(pose);
}

void MapRecording::write_picture(Timestamp stamp) {
  write_map(stamp);
  path_.stamp = stamp;
  ros::encode(path_, cdr_);
  file_.write(path_channel_, stamp, cdr_.message());
  write_closures(stamp);
}

void MapRecording::write_map(Timestamp stamp) {
  std::vector<PlacedScan> placed;
  placed.reserve(inserted_.size());
  for (const InsertedScan& inserted : inserted_) {
    placed.push_back({&inserted.scan, inserted.T_map_sensor});
  }
  ros::encode(message_from_grid(grid_from_scans(placed), kMapFrame, stamp), cdr_);
  file_.write(map_, stamp, cdr_.message());
}

void MapRecording::write_closures(Timestamp stamp) {
  std::vector<ClosureLine> lines;
  for (const LoopClosure& closure : closures_) {
    if (!closure.is_accepted || std::max(closure.stamp_i, closure.stamp_j) > stamp) continue;
    const Pose2* from = pose_at(closure.stamp_i);
    const Pose2* to = pose_at(closure.stamp_j);
    if (from == nullptr || to == nullptr) continue;
    lines.push_back({from->translation(), to->translation(), !closure.is_outvoted()});
  }
  encode_closure_markers(lines, stamp, cdr_);
  file_.write(closure_channel_, stamp, cdr_.message());
}

void MapRecording::finish() {
  if (!inserted_.empty()) write_picture(last_stamp_);
  file_.finish();
}

}  // namespace setsquare
