// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/bag/scan_messages.hpp"

#include <cctype>
#include <cmath>

namespace setsquare {
namespace {

std::int8_t cell_value(CellState state) {
  switch (state) {
    case CellState::kOccupied:
      return 100;
    case CellState::kFree:
      return 0;
    case CellState::kUnknown:
      break;
  }
  return -1;
}

}  // namespace

std::string laser_topic_name(const std::string& sensor, bool is_first) {
  if (sensor.starts_with('/')) return sensor;
  if (is_first) return "/scan";
  std::string topic = "/scan_";
  for (const char letter : sensor) {
    const auto byte = static_cast<unsigned char>(letter);
    topic += std::isalnum(byte) != 0 ? static_cast<char>(std::tolower(byte)) : '_';
  }
  return topic;
}

std::string laser_frame_name(const std::string& topic) {
  std::string frame = topic == "/scan" ? "laser" : topic.substr(1);
  for (char& letter : frame) {
    if (letter == '/') letter = '_';
  }
  return frame;
}

Eigen::Quaterniond quaternion_from_yaw(double yaw_rad) {
  return Eigen::Quaterniond(std::cos(0.5 * yaw_rad), 0.0, 0.0, std::sin(0.5 * yaw_rad));
}

void laser_scan_from_scan(const Scan& scan, const std::string& frame, ros::LaserScan& message) {
  message.stamp = scan.stamp;
  message.frame_id = frame;
  message.angle_min_rad = scan.first_bearing_rad;
  message.angle_max_rad =
      scan.num_beams() == 0 ? scan.first_bearing_rad : scan.bearing_rad(scan.num_beams() - 1);
  message.angle_increment_rad = scan.bearing_step_rad;
  message.time_increment_s = scan.time_increment_s;
  message.scan_time_s = scan.scan_time_s;
  message.range_min_m = scan.min_range_m;
  message.range_max_m = scan.max_range_m;
  message.ranges_m = scan.ranges_m;
}

ros::TransformStamped transform_from_pose(Timestamp stamp,
                                          const std::string& parent,
                                          const std::string& child,
                                          const Pose2& T_parent_child) {
  ros::TransformStamped transform;
  transform.stamp = stamp;
  transform.frame_id = parent;
  transform.child_frame_id = child;
  transform.translation_m = {T_parent_child.x_m, T_parent_child.y_m, 0.0};
  transform.rotation = quaternion_from_yaw(T_parent_child.theta_rad);
  return transform;
}

ros::OccupancyGrid message_from_grid(const OccupancyGrid& grid,
                                     const std::string& frame,
                                     Timestamp stamp) {
  ros::OccupancyGrid message;
  message.stamp = stamp;
  message.frame_id = frame;
  message.resolution_m = grid.resolution_m();
  message.width = static_cast<std::uint32_t>(grid.num_columns());
  message.height = static_cast<std::uint32_t>(grid.num_rows());
  message.origin_m = {grid.T_map_grid().x_m, grid.T_map_grid().y_m, 0.0};
  message.origin_orientation = quaternion_from_yaw(grid.T_map_grid().theta_rad);
  message.cells.reserve(grid.values().size());
  for (std::int32_t row = 0; row < grid.num_rows(); ++row) {
    for (std::int32_t column = 0; column < grid.num_columns(); ++column) {
      message.cells.push_back(cell_value(grid.state({column, row})));
    }
  }
  return message;
}

}  // namespace setsquare
