// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/mrpt/objects.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "setsquare/core/error.hpp"
#include "setsquare/io/logs/record_stream.hpp"

namespace setsquare {
namespace {

constexpr std::string_view kBadPose = "sensor pose of an unknown kind";

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
bool set_mounting(Scan& scan, const MrptPose3& sensor_pose) {
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

/// n, n ranges and, since version 1, n flags that state which are valid.
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

std::string_view read_mrpt_scan(ByteCursor& bytes, int version, LogRecord& record) {
  if (version < 0 || version > 7) return "version not known";
  Scan& scan = record.scan;
  record.kind = RecordKind::kScan;
  const auto aperture_rad = static_cast<double>(bytes.read<float>());
  const bool is_right_to_left = bytes.read_flag();
  scan.min_range_m = 0.0;
  scan.max_range_m = static_cast<double>(bytes.read<float>());
  const auto sensor_pose = read_mrpt_pose3(bytes);
  if (!sensor_pose) return kBadPose;
  const bool has_pose_covariance = version < 6;
  if (has_pose_covariance && !skip_mrpt_matrix(bytes)) return kBadPose;
  if (!read_ranges(bytes, version, scan)) return "number of beams out of bounds";
  if (!read_scan_end(bytes, version, record)) return "stamp or label out of bounds";
  set_bearings(scan, aperture_rad, is_right_to_left);
  if (!set_mounting(scan, *sensor_pose)) return "the scanner is not mounted level";
  try {
    scan.validate();
  } catch (const ParameterError&) {
    return "angles or a maximum range that no scan has";
  }
  return {};
}

std::string_view read_mrpt_odometry(ByteCursor& bytes, int version, LogRecord& record) {
  if (version < 0 || version > 2) return "version not known";
  record.kind = RecordKind::kOdometry;
  record.T_odom_base = read_mrpt_pose2(bytes);
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
  const auto increment = read_mrpt_pose2(bytes);
  if (!increment) return "pose of an unknown kind";
  movement.T_before_after = *increment;
  // The motion model's options: their size in bytes, by version.
  constexpr std::array<std::size_t, 6> kModelBytes = {44, 44, 48, 56, 56, 56};
  bytes.skip(kModelBytes[static_cast<std::size_t>(version - 2)]);
  const bool has_velocities = bytes.read_flag();
  if (version < 7) bytes.skip(2 * sizeof(float));
  if (version >= 7 && has_velocities) bytes.skip(3 * sizeof(double));
  const bool has_encoders = bytes.read_flag();
  if (version < 7 || has_encoders) bytes.skip(2 * sizeof(std::int32_t));
  movement.stamp = {};
  if (version >= 6) {
    const auto stamp = read_stamp(bytes);
    if (!stamp) return "stamp out of bounds";
    movement.stamp = *stamp;
  }
  return {};
}

}  // namespace setsquare
