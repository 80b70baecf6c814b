// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/bag/ros_log_writer.hpp"

#include <utility>

#include "setsquare/io/logs/bag/scan_messages.hpp"
#include "setsquare/io/ros/message_encoder.hpp"

namespace setsquare {
namespace {

constexpr const char* kOdometryFrame = "odom";
constexpr const char* kBaseFrame = "base_link";

}  // namespace

template <typename MessageType>
void RosLogWriter::write_message(std::optional<MessageSink::Channel>& channel,
                                 const std::string& topic,
                                 const std::string& type,
                                 const MessageType& message,
                                 Timestamp stamp) {
  if (!channel) {
    channel = sink_.add_channel(topic, type, topic == "/tf_static");
  }
  ros::encode(message, cdr_);
  sink_.write(*channel, stamp, cdr_.message());
}

bool RosLogWriter::write(const LogRecord& record) {
  switch (record.kind) {
    case RecordKind::kScan:
      record.scan.validate();
      if (record.T_odom_base) write_odometry(record);
      write_scan(record);
      return true;
    case RecordKind::kOdometry:
      if (record.T_odom_base) write_odometry(record);
      return record.T_odom_base.has_value();
    case RecordKind::kTruePose:
      if (record.T_map_base) write_true_pose(record);
      return record.T_map_base.has_value();
    case RecordKind::kTurnRate:
      break;
  }
  return false;
}

RosLogWriter::Laser& RosLogWriter::laser_of(const std::string& sensor) {
  const auto [entry, is_new] = lasers_.try_emplace(sensor);
  if (is_new) {
    const std::string topic = laser_topic_name(sensor, lasers_.size() == 1);
    entry->second.frame = laser_frame_name(topic);
    entry->second.channel = sink_.add_channel(topic, "sensor_msgs/msg/LaserScan", false);
  }
  return entry->second;
}

void RosLogWriter::write_scan(const LogRecord& record) {
  Laser& laser = laser_of(record.sensor);
  write_mounting(laser, record);
  laser_scan_from_scan(record.scan, laser.frame, scan_);
  ros::encode(scan_, cdr_);
  sink_.write(laser.channel, record.stamp, cdr_.message());
}

void RosLogWriter::write_mounting(Laser& laser, const LogRecord& record) {
  const Pose2& T_base_sensor = record.scan.T_base_sensor;
  if (laser.T_base_sensor == T_base_sensor) return;
  laser.T_base_sensor = T_base_sensor;
  const ros::TfMessage message{
      {transform_from_pose(record.stamp, kBaseFrame, laser.frame, T_base_sensor)}};
  write_message(static_transforms_, "/tf_static", "tf2_msgs/msg/TFMessage", message, record.stamp);
}

/// Scans of several lasers may carry the odometry of one moment.
void RosLogWriter::write_odometry(const LogRecord& record) {
  const Pose2& T_odom_base = *record.T_odom_base;
  if (last_stamp_ == record.stamp && last_T_odom_base_ == T_odom_base) return;
  last_stamp_ = record.stamp;
  last_T_odom_base_ = T_odom_base;
  ros::Odometry odometry;
  odometry.stamp = record.stamp;
  odometry.frame_id = kOdometryFrame;
  odometry.child_frame_id = kBaseFrame;
  odometry.position_m = {T_odom_base.x_m, T_odom_base.y_m, 0.0};
  odometry.orientation = quaternion_from_yaw(T_odom_base.theta_rad);
  odometry.velocity_m_per_s.x() = record.forward_m_per_s.value_or(0.0);
  odometry.turn_rate_rad_per_s.z() = record.turn_rad_per_s.value_or(0.0);
  write_message(odometry_, "/odom", "nav_msgs/msg/Odometry", odometry, record.stamp);
  const ros::TfMessage message{
      {transform_from_pose(record.stamp, kOdometryFrame, kBaseFrame, T_odom_base)}};
  write_message(transforms_, "/tf", "tf2_msgs/msg/TFMessage", message, record.stamp);
}

void RosLogWriter::write_true_pose(const LogRecord& record) {
  ros::PoseStamped pose;
  pose.stamp = record.stamp;
  pose.frame_id = "map";
  pose.position_m = {record.T_map_base->x_m, record.T_map_base->y_m, 0.0};
  pose.orientation = quaternion_from_yaw(record.T_map_base->theta_rad);
  write_message(true_poses_, "/ground_truth", "geometry_msgs/msg/PoseStamped", pose, record.stamp);
}

}  // namespace setsquare
