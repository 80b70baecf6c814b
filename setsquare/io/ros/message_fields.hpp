// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Which field of a ROS message goes into which member of a struct: one function per struct, which
// message_decoder.cpp calls to collect the fields that it wants and again to fill the struct. Apart
// from it since this is the one place where a field's name stands.
#pragma once

#include "setsquare/io/ros/messages.hpp"

namespace setsquare::ros {

template <typename Visitor>
void visit_fields(Visitor& visitor, PoseStamped& pose) {
  visitor.field("header.stamp", pose.stamp);
  visitor.field("header.frame_id", pose.frame_id);
  visitor.field("pose.position", pose.position_m);
  visitor.field("pose.orientation", pose.orientation);
}

template <typename Visitor>
void visit_fields(Visitor& visitor, PoseWithCovarianceStamped& pose) {
  visitor.field("header.stamp", pose.stamp);
  visitor.field("header.frame_id", pose.frame_id);
  visitor.field("pose.pose.position", pose.position_m);
  visitor.field("pose.pose.orientation", pose.orientation);
}

/// What LaserScan and MultiEchoLaserScan have in common.
template <typename Visitor>
void visit_sweep(Visitor& visitor, LaserScan& scan) {
  visitor.field("header.stamp", scan.stamp);
  visitor.field("header.frame_id", scan.frame_id);
  visitor.field("angle_min", scan.angle_min_rad);
  visitor.field("angle_max", scan.angle_max_rad);
  visitor.field("angle_increment", scan.angle_increment_rad);
  visitor.field("time_increment", scan.time_increment_s);
  visitor.field("scan_time", scan.scan_time_s);
  visitor.field("range_min", scan.range_min_m);
  visitor.field("range_max", scan.range_max_m);
}

template <typename Visitor>
void visit_fields(Visitor& visitor, LaserScan& scan) {
  visit_sweep(visitor, scan);
  visitor.field("ranges", scan.ranges_m);
}

template <typename Visitor>
void visit_fields(Visitor& visitor, MultiEchoLaserScan& scan) {
  visit_sweep(visitor, scan);
  visitor.field("ranges.echoes", scan.echoes_m);
  visitor.field("intensities.echoes", scan.intensities);
}

template <typename Visitor>
void visit_fields(Visitor& visitor, PointField& field) {
  visitor.field("name", field.name);
  visitor.field("offset", field.offset_bytes);
  visitor.field("datatype", field.datatype);
  visitor.field("count", field.count);
}

template <typename Visitor>
void visit_fields(Visitor& visitor, PointCloud2& points) {
  visitor.field("header.stamp", points.stamp);
  visitor.field("header.frame_id", points.frame_id);
  visitor.field("height", points.height);
  visitor.field("width", points.width);
  visitor.list("fields", points.fields);
  visitor.field("is_bigendian", points.is_bigendian);
  visitor.field("point_step", points.point_step_bytes);
  visitor.field("row_step", points.row_step_bytes);
  visitor.field("data", points.data);
}

template <typename Visitor>
void visit_fields(Visitor& visitor, Odometry& odometry) {
  visitor.field("header.stamp", odometry.stamp);
  visitor.field("header.frame_id", odometry.frame_id);
  visitor.field("child_frame_id", odometry.child_frame_id);
  visitor.field("pose.pose.position", odometry.position_m);
  visitor.field("pose.pose.orientation", odometry.orientation);
  visitor.field("twist.twist.linear", odometry.velocity_m_per_s);
  visitor.field("twist.twist.angular", odometry.turn_rate_rad_per_s);
}

template <typename Visitor>
void visit_fields(Visitor& visitor, Imu& imu) {
  visitor.field("header.stamp", imu.stamp);
  visitor.field("header.frame_id", imu.frame_id);
  visitor.field("orientation", imu.orientation);
  visitor.field("orientation_covariance", imu.orientation_covariance);
  visitor.field("angular_velocity", imu.turn_rate_rad_per_s);
  visitor.field("angular_velocity_covariance", imu.turn_rate_covariance);
  visitor.field("linear_acceleration", imu.acceleration_m_per_s2);
}

template <typename Visitor>
void visit_fields(Visitor& visitor, TransformStamped& transform) {
  visitor.field("header.stamp", transform.stamp);
  visitor.field("header.frame_id", transform.frame_id);
  visitor.field("child_frame_id", transform.child_frame_id);
  visitor.field("transform.translation", transform.translation_m);
  visitor.field("transform.rotation", transform.rotation);
}

template <typename Visitor>
void visit_fields(Visitor& visitor, TfMessage& message) {
  visitor.list("transforms", message.transforms);
}

template <typename Visitor>
void visit_fields(Visitor& visitor, Path& path) {
  visitor.field("header.stamp", path.stamp);
  visitor.field("header.frame_id", path.frame_id);
  visitor.list("poses", path.poses);
}

template <typename Visitor>
void visit_fields(Visitor& visitor, OccupancyGrid& grid) {
  visitor.field("header.stamp", grid.stamp);
  visitor.field("header.frame_id", grid.frame_id);
  visitor.field("info.resolution", grid.resolution_m);
  visitor.field("info.width", grid.width);
  visitor.field("info.height", grid.height);
  visitor.field("info.origin.position", grid.origin_m);
  visitor.field("info.origin.orientation", grid.origin_orientation);
  visitor.field("data", grid.cells);
}

}  // namespace setsquare::ros
