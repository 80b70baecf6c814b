// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/carmen/line.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bytes/text_scanner.hpp"
#include "setsquare/io/logs/record_stream.hpp"
#include "setsquare/scan/symmetric_bearings.hpp"

namespace setsquare {
namespace {

/// Bearings of a message that carries no angles, from the number of beams (LogOptions).
void set_symmetric_bearings(Scan& scan, const LogOptions& options) {
  const auto num_beams = static_cast<double>(scan.num_beams());
  const bool is_by_step = options.bearing_step_rad && !options.field_of_view_rad;
  const double field_of_view_rad = is_by_step
                                       ? std::abs(*options.bearing_step_rad) * (num_beams - 1.0)
                                       : options.field_of_view_rad.value_or(kPi);
  scan.bearing_step_rad =
      options.bearing_step_rad.value_or(symmetric_step_rad(field_of_view_rad, scan.num_beams()));
  scan.first_bearing_rad =
      scan.bearing_step_rad < 0.0 ? 0.5 * field_of_view_rad : -0.5 * field_of_view_rad;
}

/// Bearings of a message that carries them; a step of 0 is taken from the field of view.
void set_stated_bearings(Scan& scan, double start_rad, double field_of_view_rad, double step_rad) {
  scan.first_bearing_rad = start_rad;
  scan.bearing_step_rad = step_rad;
  if (step_rad == 0.0 && scan.num_beams() > 1) {
    scan.bearing_step_rad = field_of_view_rad / static_cast<double>(scan.num_beams() - 1);
  }
}

/// The reach from which ranges are no-returns, in m. SICK's own 81.90 or 81.91 is taken down to
/// 81.83, where its error codes begin; a reach that is not positive stands for "not stated".
double max_range_from_stated(double stated_m) {
  constexpr double kSickFirstErrorCode_m = 81.83;
  constexpr double kSickLastErrorCode_m = 81.92;
  if (!(stated_m > 0.0)) return kUnstatedMaxRange_m;
  const bool is_sick_code = stated_m > kSickFirstErrorCode_m && stated_m <= kSickLastErrorCode_m;
  return is_sick_code ? kSickFirstErrorCode_m : stated_m;
}

/// Messages of CARMEN that are not used.
constexpr std::array<std::string_view, 17> kPassedOver = {"SYNC",
                                                          "MARKER",
                                                          "COMMENT",
                                                          "NMEAGGA",
                                                          "NMEARMC",
                                                          "GPGGA",
                                                          "GPRMC",
                                                          "SONAR",
                                                          "BUMPER",
                                                          "VECTORMOVE",
                                                          "ROBOTVELOCITY",
                                                          "FOLLOWTRAJECTORY",
                                                          "BASEVELOCITY",
                                                          "LASER3",
                                                          "LASER4",
                                                          "LASER5",
                                                          "IMU"};

/// "RAWLASER1" for the prefix "RAWLASER".
bool is_numbered(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix) || name.size() == prefix.size() || name.size() > 14) return false;
  name.remove_prefix(prefix.size());
  return std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool is_scan_message(std::string_view name) {
  return name == "FLASER" || name == "RLASER" || is_numbered(name, "ROBOTLASER") ||
         is_numbered(name, "RAWLASER");
}

bool is_message(std::string_view name) {
  return is_scan_message(name) || name == "ODOM" || name == "PARAM" || name == "TRUEPOS" ||
         std::find(kPassedOver.begin(), kPassedOver.end(), name) != kPassedOver.end();
}

LineOutcome damaged(CarmenState& state, std::string_view reason) {
  state.reason = reason;
  return LineOutcome::kDamaged;
}

/// ipc_timestamp ipc_hostname logger_timestamp, and nothing behind.
LineOutcome read_tail(TextScanner& text, CarmenState& state, LogRecord& record) {
  const auto stamp_text = text.word();
  const auto host = text.word();
  const auto logger_stamp = text.word();
  constexpr std::string_view kWhatIsExpected = "stamp, host and logger stamp expected at the end";
  if (!stamp_text || !host || !logger_stamp || !text.is_at_end()) {
    return damaged(state, kWhatIsExpected);
  }
  const auto stamp = timestamp_from_decimal(*stamp_text, state.options.stamp_unit);
  const bool is_number = stamp || TextScanner(*stamp_text).finite_number();
  if (!is_number) return damaged(state, kWhatIsExpected);
  if (!stamp || stamp->ns > kMaxStamp_ns || stamp->ns < -kMaxStamp_ns) {
    return damaged(state,
                   "the stamp lies beyond the year 2112: in milliseconds or finer (--stamp-unit)?");
  }
  record.stamp = *stamp;
  record.scan.stamp = *stamp;
  return LineOutcome::kRecord;
}

/// n, then n ranges.
bool read_ranges(TextScanner& text, std::vector<double>& ranges_m) {
  const auto num_beams = text.count();
  if (!num_beams || *num_beams == 0 || *num_beams > kMaxBeams) return false;
  ranges_m.resize(*num_beams);
  return text.numbers(ranges_m);
}

/// 10^-d for a number written with d decimals, at most 1 cm (a plain "0" has no known precision).
double rounding_of(std::string_view number) {
  const std::size_t point = number.find('.');
  const std::size_t num_decimals = point == std::string_view::npos ? 0 : number.size() - point - 1;
  return std::min(0.01, std::pow(10.0, -static_cast<double>(num_decimals)));
}

/// Laser pose and robot pose: the mounting and the odometry.
bool read_poses(TextScanner& text, CarmenState& state, LogRecord& record) {
  TextScanner before = text;
  const auto first_word = before.word();
  const auto T_odom_sensor = text.pose();
  const auto T_odom_base = text.pose();
  if (!T_odom_sensor || !T_odom_base) return false;
  state.pose_rounding = rounding_of(*first_word);
  record.T_odom_base = *T_odom_base;
  record.scan.T_base_sensor = T_odom_base->inverse() * *T_odom_sensor;
  return true;
}

/// What ROBOTLASERn and RAWLASERn state about the scanner, before the ranges.
struct ScannerFields {
  double start_angle_rad = 0.0;
  double field_of_view_rad = 0.0;
  double bearing_step_rad = 0.0;
  double max_range_m = 0.0;
};

std::optional<ScannerFields> read_scanner_fields(TextScanner& text) {
  const auto laser_type = text.number();
  const auto start_rad = text.finite_number();
  const auto field_of_view_rad = text.finite_number();
  const auto step_rad = text.finite_number();
  const auto max_range_m = text.finite_number();
  const auto accuracy_m = text.number();
  const auto remission_mode = text.number();
  if (!laser_type || !start_rad || !field_of_view_rad || !step_rad || !max_range_m || !accuracy_m ||
      !remission_mode) {
    return std::nullopt;
  }
  return ScannerFields{*start_rad, *field_of_view_rad, *step_rad, *max_range_m};
}

bool skip_numbers(TextScanner& text, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!text.number()) return false;
  }
  return true;
}

/// FLASER num_readings [ranges] laser_pose robot_pose tail.
LineOutcome read_old_scan(bool is_front, TextScanner& text, CarmenState& state, LogRecord& record) {
  if (!read_ranges(text, record.scan.ranges_m))
    return damaged(state, "ranges missing or not numbers");
  if (!read_poses(text, state, record)) return damaged(state, "poses missing or not numbers");
  if (read_tail(text, state, record) == LineOutcome::kDamaged) return LineOutcome::kDamaged;
  set_symmetric_bearings(record.scan, state.options);
  record.has_assumed_bearings = true;
  record.scan.max_range_m =
      (is_front ? state.front_max_range_m : state.rear_max_range_m).value_or(kUnstatedMaxRange_m);
  return has_valid_geometry(record.scan) ? LineOutcome::kRecord
                                         : damaged(state, "angles that no scan has");
}

/// ROBOTLASERn and, without poses and safety fields, RAWLASERn.
LineOutcome read_new_scan(bool has_poses,
                          TextScanner& text,
                          CarmenState& state,
                          LogRecord& record) {
  const auto scanner = read_scanner_fields(text);
  if (!scanner) return damaged(state, "scanner fields missing or not numbers");
  if (!read_ranges(text, record.scan.ranges_m))
    return damaged(state, "ranges missing or not numbers");
  const auto num_remissions = text.count();
  if (!num_remissions || *num_remissions > kMaxBeams || !skip_numbers(text, *num_remissions)) {
    return damaged(state, "remissions missing or not numbers");
  }
  if (has_poses && !read_poses(text, state, record)) {
    return damaged(state, "poses missing or not numbers");
  }
  constexpr std::uint32_t kNumVelocityAndSafetyFields = 5;
  if (has_poses && !skip_numbers(text, kNumVelocityAndSafetyFields)) {
    return damaged(state, "velocity or safety fields missing or not numbers");
  }
  if (read_tail(text, state, record) == LineOutcome::kDamaged) return LineOutcome::kDamaged;
  set_stated_bearings(
      record.scan, scanner->start_angle_rad, scanner->field_of_view_rad, scanner->bearing_step_rad);
  record.scan.max_range_m = max_range_from_stated(scanner->max_range_m);
  return has_valid_geometry(record.scan) ? LineOutcome::kRecord
                                         : damaged(state, "angles that no scan has");
}

/// ODOM x y theta tv rv accel tail.
LineOutcome read_odometry(TextScanner& text, CarmenState& state, LogRecord& record) {
  record.T_odom_base = text.pose();
  record.forward_m_per_s = text.finite_number();
  record.turn_rad_per_s = text.finite_number();
  const auto acceleration = text.number();
  if (!record.T_odom_base || !record.forward_m_per_s || !record.turn_rad_per_s || !acceleration) {
    return damaged(state, "odometry fields missing or not numbers");
  }
  if (read_tail(text, state, record) == LineOutcome::kDamaged) return LineOutcome::kDamaged;
  record.kind = RecordKind::kOdometry;
  return LineOutcome::kRecord;
}

/// TRUEPOS true_pose odometry_pose tail.
LineOutcome read_true_pose(TextScanner& text, CarmenState& state, LogRecord& record) {
  record.T_map_base = text.pose();
  record.T_odom_base = text.pose();
  if (!record.T_map_base || !record.T_odom_base) {
    return damaged(state, "true pose and odometry pose expected");
  }
  record.kind = RecordKind::kTruePose;
  return read_tail(text, state, record);
}

/// PARAM name value ...: only the reach of the lasers matters.
LineOutcome read_parameter(TextScanner& text, CarmenState& state) {
  const auto name = text.word();
  const auto max_range_m = text.number();
  if (name && max_range_m && *max_range_m > 0.0) {
    if (*name == "robot_front_laser_max")
      state.front_max_range_m = max_range_from_stated(*max_range_m);
    if (*name == "robot_rear_laser_max")
      state.rear_max_range_m = max_range_from_stated(*max_range_m);
  }
  return LineOutcome::kNoRecord;
}

}  // namespace

LineOutcome read_carmen_line(std::string_view line, CarmenState& state, LogRecord& record) {
  if (line.empty() || line.front() == '#') return LineOutcome::kNoRecord;
  TextScanner text(line);
  const auto name = text.word();
  if (!name) return LineOutcome::kNoRecord;
  if (!is_message(*name)) return damaged(state, "unknown message");
  if (*name == "PARAM") return read_parameter(text, state);
  const bool is_scan = is_scan_message(*name);
  if (!is_scan && (state.options.scans_only || (*name != "ODOM" && *name != "TRUEPOS"))) {
    return LineOutcome::kNoRecord;
  }
  start_record(record, *name);
  if (*name == "ODOM") return read_odometry(text, state, record);
  if (*name == "TRUEPOS") return read_true_pose(text, state, record);
  if (name->starts_with("RO")) return read_new_scan(true, text, state, record);
  if (name->starts_with("RA")) return read_new_scan(false, text, state, record);
  return read_old_scan(*name == "FLASER", text, state, record);
}

bool is_carmen_log(std::string_view beginning) {
  while (!beginning.empty()) {
    TextScanner line(beginning.substr(0, beginning.find('\n')));
    const auto name = line.word();
    if (name && is_message(*name)) return true;
    const std::size_t end = beginning.find('\n');
    beginning.remove_prefix(end == std::string_view::npos ? beginning.size() : end + 1);
  }
  return false;
}

}  // namespace setsquare
