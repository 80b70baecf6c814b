// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/csv/writer.hpp"

#include <cmath>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bytes/shortest_number.hpp"
#include "setsquare/io/logs/stamp_text.hpp"

namespace setsquare {
namespace {

void append_field(std::string& table, double number) {
  table += ',';
  if (std::isnan(number)) {
    table += "nan";
  } else {
    append_shortest(table, number);
  }
}

void append_fields(std::string& table, const Pose2& pose) {
  for (const double number : {pose.x_m, pose.y_m, pose.theta_rad}) append_field(table, number);
}

/// In quotes where it holds what a table is made of.
void append_name(std::string& table, const std::string& name) {
  if (name.find_first_of("\r\n") != std::string::npos) {
    throw ParameterError("sensor", "must not have a line break");
  }
  table += ",\"";
  for (const char c : name) table.append(c == '"' ? 2 : 1, c);
  table += '"';
}

}  // namespace

void append_csv_header(std::string& table) {
  table +=
      "stamp,sensor,angle_min,angle_step,range_min,range_max,time_increment,scan_time,"
      "odom_x,odom_y,odom_theta,mounting_x,mounting_y,mounting_theta,ranges\n";
}

void append_csv_scan(std::string& table, const LogRecord& record) {
  const Scan& scan = record.scan;
  if (record.kind != RecordKind::kScan) throw ParameterError("kind", "must be a scan");
  if (scan.num_beams() == 0) throw ParameterError("ranges_m", "must hold a beam");
  scan.validate();
  table += exact_text(record.stamp);
  append_name(table, record.sensor);
  for (const double number : {scan.first_bearing_rad,
                              scan.bearing_step_rad,
                              scan.min_range_m,
                              scan.max_range_m,
                              scan.time_increment_s,
                              scan.scan_time_s}) {
    append_field(table, number);
  }
  if (record.T_odom_base) {
    append_fields(table, *record.T_odom_base);
  } else {
    table += ",,,";
  }
  append_fields(table, scan.T_base_sensor);
  for (const double range_m : scan.ranges_m) append_field(table, range_m);
  table += '\n';
}

}  // namespace setsquare
