// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/message_encoder.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

namespace setsquare::ros {
namespace {

constexpr std::size_t kNumCovariances = 36;

float single_precision(double value) {
  constexpr double kMax = std::numeric_limits<float>::max();
  if (std::abs(value) <= kMax || std::isnan(value)) return static_cast<float>(value);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  return value > 0.0 ? kInfinity : -kInfinity;
}

/// Seconds are rounded down, so that nanoseconds are not negative.
void write_time(Timestamp stamp, CdrWriter& writer) {
  constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;
  std::int64_t seconds = stamp.ns / kNanosecondsPerSecond;
  std::int64_t nanoseconds = stamp.ns % kNanosecondsPerSecond;
  if (nanoseconds < 0) {
    nanoseconds += kNanosecondsPerSecond;
    --seconds;
  }
  writer.write(static_cast<std::int32_t>(seconds));
  writer.write(static_cast<std::uint32_t>(nanoseconds));
}

void write_header(Timestamp stamp, std::string_view frame_id, CdrWriter& writer) {
  write_time(stamp, writer);
  writer.write_text(frame_id);
}

void write_vector(const Eigen::Vector3d& vector, CdrWriter& writer) {
  for (const double coordinate : {vector.x(), vector.y(), vector.z()}) writer.write(coordinate);
}

void write_quaternion(const Eigen::Quaterniond& q, CdrWriter& writer) {
  for (const double part : {q.x(), q.y(), q.z(), q.w()}) writer.write(part);
}

void write_unknown_covariances(CdrWriter& writer) {
  for (std::size_t i = 0; i < kNumCovariances; ++i) writer.write(0.0);
}

void write_pose(const PoseStamped& pose, CdrWriter& writer) {
  write_header(pose.stamp, pose.frame_id, writer);
  write_vector(pose.position_m, writer);
  write_quaternion(pose.orientation, writer);
}

void write_metadata(const OccupancyGrid& grid, CdrWriter& writer) {
  write_time(grid.stamp, writer);
  writer.write(single_precision(grid.resolution_m));
  writer.write(grid.width);
  writer.write(grid.height);
  write_vector(grid.origin_m, writer);
  write_quaternion(grid.origin_orientation, writer);
}

}  // namespace

void encode(const LaserScan& scan, CdrWriter& writer) {
  writer.start();
  write_header(scan.stamp, scan.frame_id, writer);
  for (const double value : {scan.angle_min_rad,
                             scan.angle_max_rad,
                             scan.angle_increment_rad,
                             scan.time_increment_s,
                             scan.scan_time_s,
                             scan.range_min_m,
                             scan.range_max_m}) {
    writer.write(single_precision(value));
  }
  writer.write_count(scan.ranges_m.size());
  for (const double range_m : scan.ranges_m) writer.write(single_precision(range_m));
  constexpr std::size_t kNumIntensities = 0;
  writer.write_count(kNumIntensities);
}

void encode(const Odometry& odometry, CdrWriter& writer) {
  writer.start();
  write_header(odometry.stamp, odometry.frame_id, writer);
  writer.write_text(odometry.child_frame_id);
  write_vector(odometry.position_m, writer);
  write_quaternion(odometry.orientation, writer);
  write_unknown_covariances(writer);
  write_vector(odometry.velocity_m_per_s, writer);
  write_vector(odometry.turn_rate_rad_per_s, writer);
  write_unknown_covariances(writer);
}

void encode(const TfMessage& message, CdrWriter& writer) {
  writer.start();
  writer.write_count(message.transforms.size());
  for (const TransformStamped& transform : message.transforms) {
    write_header(transform.stamp, transform.frame_id, writer);
    writer.write_text(transform.child_frame_id);
    write_vector(transform.translation_m, writer);
    write_quaternion(transform.rotation, writer);
  }
}

void encode(const PoseStamped& pose, CdrWriter& writer) {
  writer.start();
  write_pose(pose, writer);
}

void encode(const Path& path, CdrWriter& writer) {
  writer.start();
  write_header(path.stamp, path.frame_id, writer);
  writer.write_count(path.poses.size());
  for (const PoseStamped& pose : path.poses) write_pose(pose, writer);
}

void encode(const PoseWithCovarianceStamped& pose, CdrWriter& writer) {
  writer.start();
  write_pose(pose, writer);
  for (const double covariance : pose.covariance) writer.write(covariance);
}

void encode(const DiagnosticArray& diagnostics, CdrWriter& writer) {
  writer.start();
  write_header(diagnostics.stamp, "", writer);
  writer.write_count(diagnostics.statuses.size());
  for (const DiagnosticStatus& status : diagnostics.statuses) {
    writer.write(static_cast<std::uint8_t>(status.level));
    writer.write_text(status.name);
    writer.write_text(status.message);
    writer.write_text(status.hardware_id);
    writer.write_count(status.values.size());
    for (const auto& [key, value] : status.values) {
      writer.write_text(key);
      writer.write_text(value);
    }
  }
}

void encode_metadata(const OccupancyGrid& grid, CdrWriter& writer) {
  writer.start();
  write_metadata(grid, writer);
}

void encode(const OccupancyGrid& grid, CdrWriter& writer) {
  writer.start();
  write_header(grid.stamp, grid.frame_id, writer);
  write_metadata(grid, writer);
  writer.write_sequence<std::int8_t>(grid.cells);
}

}  // namespace setsquare::ros
