// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/csv/log.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/io/logs/csv/fields.hpp"
#include "setsquare/io/logs/stamp_text.hpp"

namespace setsquare {
namespace {

/// The name of a scanner that the table does not name.
constexpr std::string_view kOnlyScanner = "laser";

/// A number with a comma for its decimal point, as no table may have it.
bool has_decimal_comma(std::string_view line, char separator) {
  if (separator == ',') return false;
  const auto is_digit = [&](std::size_t i) {
    return i < line.size() && line[i] >= '0' && line[i] <= '9';
  };
  for (std::size_t comma = line.find(','); comma != std::string_view::npos;
       comma = line.find(',', comma + 1)) {
    if (comma > 0 && is_digit(comma - 1) && is_digit(comma + 1)) return true;
  }
  return false;
}

/// A pose from three numbers; nothing where one of them is missing.
std::optional<Pose2> finite_pose(double x_m, double y_m, double theta_rad) {
  if (!std::isfinite(x_m) || !std::isfinite(y_m) || !std::isfinite(theta_rad)) return std::nullopt;
  return Pose2{x_m, y_m, theta_rad};
}

}  // namespace

CsvLog::CsvLog(std::unique_ptr<InputBuffer> input, const std::string& name)
    : LineLog(std::move(input)) {
  auto table = csv_columns_from(look_ahead());
  if (!table) throw FormatError(name, "", "no table of scans");
  if (!table->fault.empty()) throw FormatError(name, "", "table of scans: " + table->fault);
  table_ = std::move(*table);
}

bool CsvLog::fail(std::string_view reason) {
  reason_ = reason;
  return false;
}

std::string CsvLog::reason(std::string_view line) const {
  const bool is_comma = has_decimal_comma(line, table_.separator);
  return std::string(is_comma ? "decimal comma: numbers need a decimal point" : reason_);
}

LineOutcome CsvLog::read_line(std::string_view line, LogRecord& record) {
  const bool is_blank = line.find_first_not_of(" \t") == std::string_view::npos;
  if (is_blank || line.front() == '#' || line == table_.header) return LineOutcome::kNoRecord;
  if (!read_fields(line, record) || !fill(record)) return LineOutcome::kDamaged;
  if (!lines().has_end() && is_cut(line, record.scan)) return LineOutcome::kDamaged;
  num_ranges_before_ = record.scan.num_beams();
  return LineOutcome::kRecord;
}

/// Whether the file's last line, which has no end, shows that the file was cut in it.
bool CsvLog::is_cut(std::string_view line, const Scan& scan) {
  const bool ends_with_separator = line.back() == table_.separator && table_.separator != ' ';
  const bool is_shorter = scan.num_beams() < num_ranges_before_;
  return (ends_with_separator || is_shorter) && !fail("fewer ranges than before");
}

bool CsvLog::read_fields(std::string_view line, LogRecord& record) {
  start_record(record, kOnlyScanner);
  numbers_.fill(std::numeric_limits<double>::quiet_NaN());
  CsvFields fields(line, table_.separator);
  for (const CsvColumn& column : table_.columns) {
    if (!fields.has_next()) {
      if (column.field == CsvField::kRange && table_.is_open_ended) break;
      return fail("fewer fields than columns");
    }
    if (!read_field(column, fields, record)) return false;
  }
  const CsvColumn& last = table_.columns.back();
  while (fields.has_next()) {
    if (!table_.is_open_ended) return fail("more fields than columns");
    if (!read_field(last, fields, record)) return false;
  }
  return true;
}

bool CsvLog::read_field(const CsvColumn& column, CsvFields& fields, LogRecord& record) {
  if (column.field == CsvField::kRange) {
    const auto range = fields.number();
    if (!range) return fail("a range is no number");
    if (record.scan.num_beams() == kMaxBeams) return fail("more ranges than a scanner has");
    record.scan.ranges_m.push_back(in_base_unit(*range, column.unit));
    return true;
  }
  const auto text = fields.text();
  if (!text) return fail("a quote is not closed");
  if (column.field == CsvField::kOther) return true;
  if (column.field == CsvField::kSensor) {
    record.sensor = *text;
    return true;
  }
  if (column.field == CsvField::kStamp) {
    const auto stamp = stamp_from_text(*text, num_decimals_of(column.unit));
    if (!stamp) return fail("the stamp is no number or out of range");
    record.stamp = record.scan.stamp = *stamp;
    return true;
  }
  const auto read = number_from_field(*text);
  if (!read) return fail("a field is no number");
  numbers_[static_cast<std::size_t>(column.field)] = in_base_unit(*read, column.unit);
  return true;
}

/// The record of the numbers of its line.
bool CsvLog::fill(LogRecord& record) {
  const auto number_or = [&](CsvField field, double unstated) {
    return std::isnan(number(field)) ? unstated : number(field);
  };
  const auto is_stated = [&](CsvField x, CsvField y, CsvField theta) {
    return !std::isnan(number(x)) || !std::isnan(number(y)) || !std::isnan(number(theta));
  };
  Scan& scan = record.scan;
  if (scan.num_beams() == 0) return fail("no ranges");
  scan.first_bearing_rad = number(CsvField::kAngleMin);
  scan.bearing_step_rad = number(CsvField::kAngleStep);
  scan.min_range_m = number_or(CsvField::kRangeMin, 0.0);
  scan.max_range_m = number_or(CsvField::kRangeMax, kUnstatedMaxRange_m);
  scan.time_increment_s = number_or(CsvField::kTimeIncrement, 0.0);
  scan.scan_time_s = number_or(CsvField::kScanTime, 0.0);
  if (is_stated(CsvField::kOdomX, CsvField::kOdomY, CsvField::kOdomTheta)) {
    record.T_odom_base = finite_pose(
        number(CsvField::kOdomX), number(CsvField::kOdomY), number(CsvField::kOdomTheta));
    if (!record.T_odom_base) return fail("odometry is not three finite numbers");
  }
  if (is_stated(CsvField::kMountingX, CsvField::kMountingY, CsvField::kMountingTheta)) {
    const auto mounting = finite_pose(number(CsvField::kMountingX),
                                      number(CsvField::kMountingY),
                                      number(CsvField::kMountingTheta));
    if (!mounting) return fail("the mounting is not three finite numbers");
    scan.T_base_sensor = *mounting;
  }
  return has_valid_geometry(scan) || fail("angles or limits that no scan has");
}

}  // namespace setsquare
