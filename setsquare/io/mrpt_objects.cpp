// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/mrpt_objects.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "setsquare/core/error.hpp"
#include "setsquare/io/record_stream.hpp"

namespace setsquare {
namespace {

constexpr std::string_view kBadPose = "sensor pose of an unknown kind";

bool is_class_name(std::string_view name) {
  const auto is_allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == ':';
  };
  return (name.starts_with('C') || name.starts_with("mrpt::")) &&
         std::all_of(name.begin(), name.end(), is_allowed);
}

/// The header of a part of an object, which must be of this class.
std::optional<MrptHeader> read_part_header(ByteCursor& bytes, std::string_view class_name) {
  const auto header = read_mrpt_header(bytes);
  if (!header || header->class_name != class_name) return std::nullopt;
  return header;
}

/// CMatrix (of float) or CMatrixD: rows, columns, values row by row.
template <typename Value>
bool read_matrix(ByteCursor& bytes, std::array<double, 16>* values_4x4) {
  const auto header = read_mrpt_header(bytes);
  if (!header || !header->class_name.starts_with("CMatrix") || header->version != 0) return false;
  const auto num_rows = bytes.read<std::uint32_t>();
  const auto num_columns = bytes.read<std::uint32_t>();
  constexpr std::uint32_t kMaxSide = 16;
  if (num_rows > kMaxSide || num_columns > kMaxSide) return false;
  if (values_4x4 == nullptr) {
    bytes.skip(sizeof(Value) * num_rows * num_columns);
  } else {
    if (num_rows != 4 || num_columns != 4) return false;
    for (double& value : *values_4x4) value = static_cast<double>(bytes.read<Value>());
  }
  return read_mrpt_end(bytes, *header);
}

/// A pose in space: position and rotation matrix, row by row.
struct Pose3 {
  std::array<double, 3> position_m{};
  std::array<double, 9> rotation{};
};

Pose3 pose3_from_matrix(const std::array<double, 16>& m) {
  return {{m[3], m[7], m[11]}, {m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]}};
}

/// Position and quaternion (w x y z).
Pose3 read_position_and_quaternion(ByteCursor& bytes) {
  Pose3 pose;
  for (double& coordinate : pose.position_m) coordinate = bytes.read<double>();
  const auto w = bytes.read<double>();
  const auto x = bytes.read<double>();
  const auto y = bytes.read<double>();
  const auto z = bytes.read<double>();
  pose.rotation = {w * w + x * x - y * y - z * z,
                   2.0 * (x * y - w * z),
                   2.0 * (x * z + w * y),
                   2.0 * (x * y + w * z),
                   w * w - x * x + y * y - z * z,
                   2.0 * (y * z - w * x),
                   2.0 * (x * z - w * y),
                   2.0 * (y * z + w * x),
                   w * w - x * x - y * y + z * z};
  return pose;
}

/// CPose3D, versions 0 to 3.
std::optional<Pose3> read_pose3(ByteCursor& bytes) {
  const auto header = read_part_header(bytes, "CPose3D");
  if (!header) return std::nullopt;
  Pose3 pose;
  std::array<double, 16> matrix{};
  if (header->version == 0) {
    if (!read_matrix<float>(bytes, &matrix)) return std::nullopt;
    pose = pose3_from_matrix(matrix);
  } else if (header->version == 1) {
    if (!read_matrix<double>(bytes, &matrix)) return std::nullopt;
    pose = pose3_from_matrix(matrix);
  } else if (header->version == 2) {
    pose = read_position_and_quaternion(bytes);
  } else if (header->version == 3) {
    for (double& coordinate : pose.position_m) coordinate = bytes.read<double>();
    for (double& element : pose.rotation) element = bytes.read<double>();
  } else {
    return std::nullopt;
  }
  if (!read_mrpt_end(bytes, *header)) return std::nullopt;
  return pose;
}

/// CPose2D: version 0 in float, version 1 in double.
std::optional<Pose2> read_pose2(ByteCursor& bytes) {
  const auto header = read_part_header(bytes, "CPose2D");
  if (!header || header->version > 1) return std::nullopt;
  std::array<double, 3> values{};
  for (double& value : values) {
    value = header->version == 0 ? static_cast<double>(bytes.read<float>()) : bytes.read<double>();
    if (!std::isfinite(value)) return std::nullopt;
  }
  if (!read_mrpt_end(bytes, *header)) return std::nullopt;
  return Pose2{values[0], values[1], values[2]};
}

/// 100 ns ticks since 1601 (UTC) to the Unix epoch's nanoseconds; 0 means "no stamp".
std::optional<Timestamp> read_stamp(ByteCursor& bytes) {
  constexpr std::int64_t kTicksTo1970 = 116'444'736'000'000'000;
  constexpr std::int64_t kNanosecondsPerTick = 100;
  const auto ticks = bytes.read<std::int64_t>();
  if (ticks == 0) return Timestamp{};
  constexpr std::int64_t kMaxTicks = kMaxStamp_ns / kNanosecondsPerTick;
  if (ticks < kTicksTo1970 - kMaxTicks || ticks > kTicksTo1970 + kMaxTicks) return std::nullopt;
  return Timestamp{(ticks - kTicksTo1970) * kNanosecondsPerTick};
}

/// A sensor's label, anything but plain ASCII made visible; "laser" where it has none.
bool read_label(ByteCursor& bytes, std::string& label) {
  constexpr std::uint32_t kMaxLabelBytes = 1024;
  const auto num_bytes = bytes.read<std::uint32_t>();
  if (num_bytes > kMaxLabelBytes) return false;
  label = bytes.take(num_bytes);
  for (char& c : label) {
    if (c < ' ' || c > '~') c = '?';
  }
  return true;
}

void set_bearings(Scan& scan, double aperture_rad, bool is_right_to_left) {
  const std::size_t num_beams = scan.num_beams();
  const double step_rad =
      num_beams > 1 ? aperture_rad / static_cast<double>(num_beams - 1) : aperture_rad;
  scan.first_bearing_rad = is_right_to_left ? -0.5 * aperture_rad : 0.5 * aperture_rad;
  scan.bearing_step_rad = is_right_to_left ? step_rad : -step_rad;
}

/// The sensor's pose on the robot seen from above; false where the scanner is not level.
bool set_mounting(Scan& scan, const Pose3& sensor_pose) {
  constexpr double kMinVerticality = 0.94;  // cos(20 degrees)
  const double verticality = sensor_pose.rotation[8];
  if (!(std::abs(verticality) >= kMinVerticality)) return false;
  scan.T_base_sensor = {sensor_pose.position_m[0],
                        sensor_pose.position_m[1],
                        std::atan2(sensor_pose.rotation[3], sensor_pose.rotation[0])};
  if (verticality < 0.0) {  // upside down
    scan.first_bearing_rad = -scan.first_bearing_rad;
    scan.bearing_step_rad = -scan.bearing_step_rad;
  }
  return std::isfinite(scan.T_base_sensor.x_m) && std::isfinite(scan.T_base_sensor.y_m) &&
         std::isfinite(scan.T_base_sensor.theta_rad);
}

/// n, n ranges and, since version 1, n flags that tell which are valid.
bool read_ranges(ByteCursor& bytes, int version, Scan& scan) {
  const auto num_beams = bytes.read<std::uint32_t>();
  if (num_beams == 0 || num_beams > kMaxBeams) return false;
  scan.ranges_m.clear();
  const std::string_view ranges = bytes.take(num_beams * sizeof(float));
  const std::string_view flags = version >= 1 ? bytes.take(num_beams) : std::string_view{};
  if (bytes.is_short()) return false;
  ByteCursor range_bytes(ranges);
  for (std::uint32_t beam = 0; beam < num_beams; ++beam) {
    const auto range_m = static_cast<double>(range_bytes.read<float>());
    const bool is_marked_invalid = !flags.empty() && flags[beam] == 0;
    const bool tells_nothing = is_marked_invalid && range_m < scan.max_range_m;
    scan.ranges_m.push_back(tells_nothing ? std::numeric_limits<double>::quiet_NaN() : range_m);
  }
  return true;
}

/// What stands behind the ranges: noise, stamp, beam width, label, intensities.
bool read_scan_end(ByteCursor& bytes, int version, LogRecord& record) {
  if (version >= 2) bytes.skip(sizeof(float));
  record.stamp = {};
  if (version >= 3) {
    const auto stamp = read_stamp(bytes);
    if (!stamp) return false;
    record.stamp = *stamp;
  }
  record.scan.stamp = record.stamp;
  record.sensor.clear();
  if (version >= 4) bytes.skip(sizeof(float));
  if (version >= 5) {
    if (!read_label(bytes, record.sensor)) return false;
    bytes.skip(sizeof(double));
  }
  if (record.sensor.empty()) record.sensor = "laser";
  if (version >= 7 && bytes.read_flag()) bytes.skip(record.scan.num_beams() * sizeof(std::int32_t));
  return true;
}

}  // namespace

std::optional<MrptHeader> read_mrpt_header(ByteCursor& bytes) {
  constexpr std::uint8_t kNewFormat = 0x80;
  constexpr std::size_t kMaxNameBytes = 120;
  const auto length = bytes.read<std::uint8_t>();
  MrptHeader header;
  header.has_end_flag = (length & kNewFormat) != 0;
  if (!header.has_end_flag && bytes.take(3) != std::string_view("\0\0\0", 3)) return std::nullopt;
  const std::size_t num_name_bytes = length & 0x7fU;
  if (num_name_bytes == 0 || num_name_bytes > kMaxNameBytes) return std::nullopt;
  header.class_name = bytes.take(num_name_bytes);
  if (!is_class_name(header.class_name)) return std::nullopt;
  const std::size_t space = header.class_name.rfind(':');
  if (space != std::string_view::npos) header.class_name.remove_prefix(space + 1);
  header.version = header.has_end_flag ? bytes.read<std::uint8_t>() : bytes.read<std::int32_t>();
  if (bytes.is_short()) return std::nullopt;
  return header;
}

bool read_mrpt_end(ByteCursor& bytes, const MrptHeader& header) {
  return !header.has_end_flag || bytes.read<std::uint8_t>() == kMrptEndFlag;
}

std::string_view read_mrpt_scan(ByteCursor& bytes, int version, LogRecord& record) {
  if (version < 0 || version > 7) return "version not known";
  Scan& scan = record.scan;
  record.kind = RecordKind::kScan;
  const auto aperture_rad = static_cast<double>(bytes.read<float>());
  const bool is_right_to_left = bytes.read_flag();
  scan.min_range_m = 0.0;
  scan.max_range_m = static_cast<double>(bytes.read<float>());
  const auto sensor_pose = read_pose3(bytes);
  if (!sensor_pose) return kBadPose;
  const bool has_pose_covariance = version < 6;
  if (has_pose_covariance && !read_matrix<float>(bytes, nullptr)) return kBadPose;
  if (!read_ranges(bytes, version, scan)) return "number of beams out of bounds";
  if (!read_scan_end(bytes, version, record)) return "stamp or label out of bounds";
  set_bearings(scan, aperture_rad, is_right_to_left);
  if (!set_mounting(scan, *sensor_pose)) return "the scanner is not mounted level";
  try {
    scan.validate();
  } catch (const ParameterError&) {
    return "angles or maximum range that are no scan's";
  }
  return {};
}

std::string_view read_mrpt_odometry(ByteCursor& bytes, int version, LogRecord& record) {
  if (version < 0 || version > 2) return "version not known";
  record.kind = RecordKind::kOdometry;
  record.T_odom_base = read_pose2(bytes);
  if (!record.T_odom_base) return "pose of an unknown kind";
  if (!read_label(bytes, record.sensor)) return "label out of bounds";
  if (record.sensor.empty()) record.sensor = "odometry";
  const auto stamp = read_stamp(bytes);
  if (!stamp) return "stamp out of bounds";
  record.stamp = *stamp;
  record.forward_m_per_s.reset();
  record.turn_rad_per_s.reset();
  if (version == 0) return {};
  const bool has_encoders = bytes.read_flag();
  if (has_encoders || version < 2) bytes.skip(2 * sizeof(std::int32_t));
  const bool has_velocities = bytes.read_flag();
  if (version < 2) {
    const auto forward_m_per_s = static_cast<double>(bytes.read<float>());
    const auto turn_rad_per_s = static_cast<double>(bytes.read<float>());
    if (has_velocities) record.forward_m_per_s = forward_m_per_s;
    if (has_velocities) record.turn_rad_per_s = turn_rad_per_s;
  } else if (has_velocities) {
    record.forward_m_per_s = bytes.read<double>();
    bytes.skip(sizeof(double));  // sideways
    record.turn_rad_per_s = bytes.read<double>();
  }
  return {};
}

std::string_view read_mrpt_movement(ByteCursor& bytes, int version, MrptMovement& movement) {
  if (version < 2 || version > 7) return "version not known";
  constexpr std::int32_t kByOdometry = 0;
  if (bytes.read<std::int32_t>() != kByOdometry) return "a motion that is not odometry's";
  const auto increment = read_pose2(bytes);
  if (!increment) return "pose of an unknown kind";
  movement.T_before_after = *increment;
  // The motion model's options: their size in bytes, by version.
  constexpr std::array<std::size_t, 6> kModelBytes = {44, 44, 48, 56, 56, 56};
  bytes.skip(kModelBytes[static_cast<std::size_t>(version - 2)]);
  bytes.skip(sizeof(std::uint8_t));  // whether it has velocities
  bytes.skip(version >= 7 ? 3 * sizeof(double) : 2 * sizeof(float));
  bytes.skip(sizeof(std::uint8_t) + 2 * sizeof(std::int32_t));  // encoders
  movement.stamp = {};
  if (version >= 6) {
    const auto stamp = read_stamp(bytes);
    if (!stamp) return "stamp out of bounds";
    movement.stamp = *stamp;
  }
  return {};
}

}  // namespace setsquare
