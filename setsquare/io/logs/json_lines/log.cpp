// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/json_lines/log.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "setsquare/io/logs/json_lines/scanner.hpp"
#include "setsquare/io/logs/stamp_text.hpp"

namespace setsquare {
namespace {

/// The name of a scanner that a line does not name.
constexpr std::string_view kUnnamedScanner = "laser";

struct JsonScanNumber {
  std::string_view name;
  double Scan::*value;
};

constexpr JsonScanNumber kScanNumbers[] = {
    {"angle_min", &Scan::first_bearing_rad},
    {"angle_step", &Scan::bearing_step_rad},
    {"angle_increment", &Scan::bearing_step_rad},
    {"range_min", &Scan::min_range_m},
    {"range_max", &Scan::max_range_m},
    {"time_increment", &Scan::time_increment_s},
    {"scan_time", &Scan::scan_time_s},
};

bool is_stamp_name(std::string_view name) {
  return name == "stamp" || name == "time" || name == "timestamp";
}

/// [x, y, theta], or nothing for null.
bool read_json_pose(JsonScanner& json, std::optional<Pose2>& pose) {
  pose.reset();
  if (json.take_null()) return true;
  std::vector<double> numbers;
  if (!json.numbers(numbers, 3) || numbers.size() != 3) return false;
  for (const double number : numbers) {
    if (!std::isfinite(number)) return false;
  }
  pose = Pose2{numbers[0], numbers[1], numbers[2]};
  return true;
}

/// A finite number, or nothing for null.
bool read_json_speed(JsonScanner& json, std::optional<double>& speed) {
  speed = json.number();
  if (!speed || std::isinf(*speed)) return false;
  if (std::isnan(*speed)) speed.reset();
  return true;
}

bool read_json_mounting(JsonScanner& json, Pose2& T_base_sensor) {
  std::optional<Pose2> mounting;
  if (!read_json_pose(json, mounting)) return false;
  T_base_sensor = mounting.value_or(Pose2{});
  return true;
}

/// Numbers that a line does not state, or states as null.
void set_unstated(Scan& scan) {
  if (std::isnan(scan.max_range_m)) scan.max_range_m = kUnstatedMaxRange_m;
  for (double* const number : {&scan.min_range_m, &scan.time_increment_s, &scan.scan_time_s}) {
    if (std::isnan(*number)) *number = 0.0;
  }
}

}  // namespace

bool is_json_lines_log(std::string_view beginning) {
  const std::size_t first = beginning.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || beginning[first] != '{') return false;
  const std::size_t second = beginning.find_first_not_of(" \t", first + 1);
  return second != std::string_view::npos && (beginning[second] == '"' || beginning[second] == '}');
}

JsonLinesLog::JsonLinesLog(std::unique_ptr<InputBuffer> input, const LogOptions& options)
    : LineLog(std::move(input)), scans_only_(options.scans_only) {}

bool JsonLinesLog::fail(std::string reason) {
  reason_ = std::move(reason);
  return false;
}

LineOutcome JsonLinesLog::read_line(std::string_view line, LogRecord& record) {
  if (JsonScanner(line).is_at_end() || line.front() == '#') return LineOutcome::kNoRecord;
  if (!read_object(line, record) || !check(record)) return LineOutcome::kDamaged;
  const bool is_wanted = record.kind == RecordKind::kScan || !scans_only_;
  return is_wanted ? LineOutcome::kRecord : LineOutcome::kNoRecord;
}

bool JsonLinesLog::read_object(std::string_view line, LogRecord& record) {
  start_record(record, kUnnamedScanner);
  constexpr double kUnstated = std::numeric_limits<double>::quiet_NaN();
  record.scan.first_bearing_rad = record.scan.bearing_step_rad = record.scan.max_range_m =
      kUnstated;
  has_stamp_ = has_ranges_ = false;
  JsonScanner json(line);
  if (!json.take('{')) return fail("no JSON object");
  bool has_more = !json.take('}');
  while (has_more) {
    const auto name = json.string();
    if (!name || !json.take(':')) return fail("no JSON object: a name and a colon expected");
    if (!read_member(json, *name, record)) {
      return fail(fmt::format("\"{}\" is not as it must be", shown_beginning(*name)));
    }
    has_more = json.take(',');
    if (!has_more && !json.take('}')) return fail("no JSON object: comma or } expected");
  }
  return json.is_at_end() || fail("text behind the JSON object");
}

bool JsonLinesLog::read_member(JsonScanner& json, std::string_view name, LogRecord& record) {
  Scan& scan = record.scan;
  if (name == "ranges") {
    scan.ranges_m.clear();
    has_ranges_ = true;
    return json.numbers(scan.ranges_m, kMaxBeams) && !scan.ranges_m.empty();
  }
  if (is_stamp_name(name)) {
    const auto text = json.number_text();
    const auto stamp = text ? stamp_from_text(*text) : std::nullopt;
    has_stamp_ = stamp.has_value();
    if (stamp) record.stamp = scan.stamp = *stamp;
    return has_stamp_;
  }
  if (name == "sensor") {
    auto sensor = json.string();
    if (sensor) record.sensor = std::move(*sensor);
    return sensor.has_value();
  }
  if (name == "odometry") return read_json_pose(json, record.T_odom_base);
  if (name == "true_pose") return read_json_pose(json, record.T_map_base);
  if (name == "forward_speed") return read_json_speed(json, record.forward_m_per_s);
  if (name == "turn_rate") return read_json_speed(json, record.turn_rad_per_s);
  if (name == "mounting") return read_json_mounting(json, scan.T_base_sensor);
  for (const JsonScanNumber& known : kScanNumbers) {
    if (name != known.name) continue;
    const auto number = json.number();
    if (number) scan.*known.value = *number;
    return number.has_value();
  }
  return json.skip_value();
}

/// Whether the line held what its kind of record needs.
bool JsonLinesLog::check(LogRecord& record) {
  if (!has_stamp_) return fail("no \"stamp\"");
  Scan& scan = record.scan;
  if (!has_ranges_) {
    if (!record.T_map_base && !record.T_odom_base && !record.turn_rad_per_s) {
      return fail("no \"ranges\", \"odometry\", \"true_pose\" or \"turn_rate\"");
    }
    record.kind = record.T_map_base    ? RecordKind::kTruePose
                  : record.T_odom_base ? RecordKind::kOdometry
                                       : RecordKind::kTurnRate;
    scan = Scan{};
    scan.stamp = record.stamp;
    return true;
  }
  if (std::isnan(scan.first_bearing_rad)) return fail("no \"angle_min\"");
  if (std::isnan(scan.bearing_step_rad)) return fail("no \"angle_step\"");
  set_unstated(scan);
  return has_valid_geometry(scan) || fail("angles or limits that no scan has");
}

}  // namespace setsquare
