// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The ROS messages that Setsquare reads or writes, as far as it needs them: field by field what the
// message says, not judged. Names are the messages' own, with units; frames are named as sent.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "setsquare/core/timestamp.hpp"
#include "setsquare/io/ros/field_columns.hpp"

namespace setsquare::ros {

/// sensor_msgs/LaserScan.
struct LaserScan {
  Timestamp stamp;  ///< Of the first beam; zero where the sender sets none.
  std::string frame_id;
  double angle_min_rad = 0.0;
  double angle_max_rad = 0.0;
  double angle_increment_rad = 0.0;
  double time_increment_s = 0.0;  ///< From a beam to the next.
  double scan_time_s = 0.0;       ///< From a scan to the next.
  double range_min_m = 0.0;
  double range_max_m = 0.0;
  std::vector<double> ranges_m;
};

/// sensor_msgs/MultiEchoLaserScan: each beam with any number of ranges. `ranges_m` stays empty
/// until choose_echoes fills it.
struct MultiEchoLaserScan : LaserScan {
  std::vector<NumberArray> echoes_m;     ///< Per beam; valid as long as the message's bytes.
  std::vector<NumberArray> intensities;  ///< Per beam, or empty.
};

/// sensor_msgs/PointField: where a coordinate stands in a point's bytes.
struct PointField {
  std::string name;  ///< "x", "intensity", "ring" ...
  std::uint32_t offset_bytes = 0;
  std::uint32_t datatype =
      0;  ///< 1 to 8: int8, uint8, int16, uint16, int32, uint32, float32, float64.
  std::uint32_t count = 0;
};

/// sensor_msgs/PointCloud2.
struct PointCloud2 {
  Timestamp stamp;
  std::string frame_id;
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  bool is_bigendian = false;
  std::uint32_t point_step_bytes = 0;
  std::uint32_t row_step_bytes = 0;
  NumberArray data;  ///< Valid as long as the message's bytes.
  std::vector<PointField> fields;
};

/// nav_msgs/Odometry, without covariances.
struct Odometry {
  Timestamp stamp;
  std::string frame_id;  ///< In which the pose is given: "odom".
  std::string
      child_frame_id;  ///< Whose pose it is, and in which the speeds are given: "base_link".
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d velocity_m_per_s = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn_rate_rad_per_s = Eigen::Vector3d::Zero();
};

/// geometry_msgs/PoseStamped.
struct PoseStamped {
  Timestamp stamp;
  std::string frame_id;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
};

/// geometry_msgs/PoseWithCovarianceStamped. The covariance is written, not read.
struct PoseWithCovarianceStamped : PoseStamped {
  std::array<double, 36> covariance{};  ///< Of x, y, z, turns about x, y, z; row by row.
};

/// sensor_msgs/Imu. A covariance that begins with -1 says that its quantity is not measured.
struct Imu {
  Timestamp stamp;
  std::string frame_id;
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  std::array<double, 9> orientation_covariance{};
  Eigen::Vector3d turn_rate_rad_per_s = Eigen::Vector3d::Zero();
  std::array<double, 9> turn_rate_covariance{};
  Eigen::Vector3d acceleration_m_per_s2 = Eigen::Vector3d::Zero();

  [[nodiscard]] bool has_orientation() const { return orientation_covariance[0] != -1.0; }
  [[nodiscard]] bool has_turn_rate() const { return turn_rate_covariance[0] != -1.0; }
};

/// geometry_msgs/TransformStamped: maps points of `child_frame_id` into `frame_id`.
struct TransformStamped {
  Timestamp stamp;
  std::string frame_id;
  std::string child_frame_id;
  Eigen::Vector3d translation_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
};

/// tf2_msgs/TFMessage and tf/tfMessage.
struct TfMessage {
  std::vector<TransformStamped> transforms;
};

/// nav_msgs/Path.
struct Path {
  Timestamp stamp;
  std::string frame_id;
  std::vector<PoseStamped> poses;
};

/// nav_msgs/OccupancyGrid.
struct OccupancyGrid {
  Timestamp stamp;
  std::string frame_id;
  double resolution_m = 0.0;  ///< A cell's side; float32 in the message.
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();  ///< Of the lower left corner of cell (0, 0).
  Eigen::Quaterniond origin_orientation = Eigen::Quaterniond::Identity();
  std::vector<std::int8_t> cells;  ///< Row by row from below: 0 to 100 occupied, -1 unknown.
};

/// diagnostic_msgs/DiagnosticStatus.
struct DiagnosticStatus {
  enum class Level : std::uint8_t { kOk, kWarning, kError, kStale };

  Level level = Level::kOk;
  std::string name;
  std::string message;
  std::string hardware_id;
  std::vector<std::pair<std::string, std::string>> values;
};

/// diagnostic_msgs/DiagnosticArray.
struct DiagnosticArray {
  Timestamp stamp;
  std::vector<DiagnosticStatus> statuses;
};

}  // namespace setsquare::ros
