// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/json_lines/writer.hpp"

#include <cmath>
#include <span>
#include <string_view>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bytes/shortest_number.hpp"
#include "setsquare/io/logs/stamp_text.hpp"

namespace setsquare {
namespace {

void append_json_number(std::string& log, double number) {
  if (std::isnan(number)) {
    log += "null";
  } else if (std::isinf(number)) {
    log += number > 0.0 ? "\"inf\"" : "\"-inf\"";
  } else {
    append_shortest(log, number);
  }
}

void append_json_text(std::string& log, std::string_view text) {
  constexpr std::string_view kHexDigits = "0123456789abcdef";
  log += '"';
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      (log += '\\') += c;
    } else if (code < 0x20) {
      ((log += "\\u00") += kHexDigits[code >> 4U]) += kHexDigits[code & 0xfU];
    } else {
      log += c;
    }
  }
  log += '"';
}

void append_json_name(std::string& log, std::string_view name) {
  ((log += ",\"") += name) += "\":";
}

void append_json_array(std::string& log, std::string_view name, std::span<const double> numbers) {
  append_json_name(log, name);
  char before = '[';
  for (const double number : numbers) {
    log += before;
    append_json_number(log, number);
    before = ',';
  }
  log += ']';
}

void append_json_pose(std::string& log, std::string_view name, const Pose2& pose) {
  const double numbers[] = {pose.x_m, pose.y_m, pose.theta_rad};
  append_json_array(log, name, numbers);
}

void append_json_member(std::string& log, std::string_view name, double number) {
  append_json_name(log, name);
  append_json_number(log, number);
}

void append_json_scan(std::string& log, const Scan& scan) {
  append_json_member(log, "angle_min", scan.first_bearing_rad);
  append_json_member(log, "angle_step", scan.bearing_step_rad);
  append_json_member(log, "range_min", scan.min_range_m);
  append_json_member(log, "range_max", scan.max_range_m);
  append_json_member(log, "time_increment", scan.time_increment_s);
  append_json_member(log, "scan_time", scan.scan_time_s);
  append_json_pose(log, "mounting", scan.T_base_sensor);
  append_json_array(log, "ranges", scan.ranges_m);
}

void validate_record(const LogRecord& record) {
  switch (record.kind) {
    case RecordKind::kScan:
      if (record.scan.num_beams() == 0) throw ParameterError("ranges_m", "must hold a beam");
      record.scan.validate();
      break;
    case RecordKind::kOdometry:
      if (!record.T_odom_base) throw ParameterError("T_odom_base", "must be there for odometry");
      break;
    case RecordKind::kTruePose:
      if (!record.T_map_base) throw ParameterError("T_map_base", "must be there for a true pose");
      break;
    case RecordKind::kTurnRate:
      if (!record.turn_rad_per_s || record.T_odom_base || record.T_map_base) {
        throw ParameterError("turn_rad_per_s", "must be there for a turn rate, and no pose");
      }
      break;
  }
}

}  // namespace

void append_json_record(std::string& log, const LogRecord& record) {
  validate_record(record);
  log += "{\"stamp\":";
  log += exact_text(record.stamp);
  append_json_name(log, "sensor");
  append_json_text(log, record.sensor);
  if (record.T_odom_base) append_json_pose(log, "odometry", *record.T_odom_base);
  if (record.T_map_base) append_json_pose(log, "true_pose", *record.T_map_base);
  if (record.forward_m_per_s) append_json_member(log, "forward_speed", *record.forward_m_per_s);
  if (record.turn_rad_per_s) append_json_member(log, "turn_rate", *record.turn_rad_per_s);
  if (record.kind == RecordKind::kScan) append_json_scan(log, record.scan);
  log += "}\n";
}

}  // namespace setsquare
