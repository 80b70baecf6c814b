// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/csv/columns.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "setsquare/core/angle.hpp"
#include "setsquare/io/logs/csv/fields.hpp"

namespace setsquare {
namespace {

enum class CsvDimension { kNone, kTime, kAngle, kLength };

struct CsvName {
  std::string_view name;
  CsvField field;
  CsvDimension dimension;
};

constexpr CsvName kCsvNames[] = {
    {"stamp", CsvField::kStamp, CsvDimension::kTime},
    {"time", CsvField::kStamp, CsvDimension::kTime},
    {"timestamp", CsvField::kStamp, CsvDimension::kTime},
    {"sensor", CsvField::kSensor, CsvDimension::kNone},
    {"frame_id", CsvField::kSensor, CsvDimension::kNone},
    {"angle_min", CsvField::kAngleMin, CsvDimension::kAngle},
    {"angle_step", CsvField::kAngleStep, CsvDimension::kAngle},
    {"angle_increment", CsvField::kAngleStep, CsvDimension::kAngle},
    {"range_min", CsvField::kRangeMin, CsvDimension::kLength},
    {"range_max", CsvField::kRangeMax, CsvDimension::kLength},
    {"time_increment", CsvField::kTimeIncrement, CsvDimension::kTime},
    {"scan_time", CsvField::kScanTime, CsvDimension::kTime},
    {"odom_x", CsvField::kOdomX, CsvDimension::kLength},
    {"odom_y", CsvField::kOdomY, CsvDimension::kLength},
    {"odom_theta", CsvField::kOdomTheta, CsvDimension::kAngle},
    {"mounting_x", CsvField::kMountingX, CsvDimension::kLength},
    {"mounting_y", CsvField::kMountingY, CsvDimension::kLength},
    {"mounting_theta", CsvField::kMountingTheta, CsvDimension::kAngle},
    {"ranges", CsvField::kRange, CsvDimension::kLength},
};

struct CsvSuffix {
  std::string_view suffix;
  CsvDimension dimension;
  CsvUnit unit;
};

constexpr CsvSuffix kCsvSuffixes[] = {
    {"_s", CsvDimension::kTime, CsvUnit::kBase},
    {"_ms", CsvDimension::kTime, CsvUnit::kMillisecond},
    {"_us", CsvDimension::kTime, CsvUnit::kMicrosecond},
    {"_ns", CsvDimension::kTime, CsvUnit::kNanosecond},
    {"_rad", CsvDimension::kAngle, CsvUnit::kBase},
    {"_deg", CsvDimension::kAngle, CsvUnit::kDegree},
    {"_m", CsvDimension::kLength, CsvUnit::kBase},
    {"_cm", CsvDimension::kLength, CsvUnit::kCentimetre},
    {"_mm", CsvDimension::kLength, CsvUnit::kMillimetre},
};

/// Columns that `rostopic echo -p` names in its own way, and counts in ns.
constexpr std::string_view kNanosecondNames[] = {"%time", "header.stamp"};

/// "range_12", "ranges_12", "ranges12" and "ranges[12]" are "ranges".
std::string without_index(std::string name) {
  const std::size_t last = name.find_last_not_of("0123456789]");
  if (last == std::string::npos || last + 1 == name.size() || !name.starts_with("range")) {
    return name;
  }
  std::string stem = name.substr(0, last + 1);
  if (stem.back() == '_' || stem.back() == '[') stem.pop_back();
  return stem == "range" || stem == "ranges" ? "ranges" : name;
}

std::string plain_name(std::string_view written) {
  std::string name(written);
  std::ranges::transform(name, name.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  for (const std::string_view prefix : {"field.", "header."}) {
    const bool is_stamp = name == "header.stamp";
    if (name.starts_with(prefix) && !is_stamp) name.erase(0, prefix.size());
  }
  return without_index(std::move(name));
}

CsvColumn column_named(std::string_view written) {
  const std::string name = plain_name(written);
  if (std::ranges::find(kNanosecondNames, name) != std::end(kNanosecondNames)) {
    return {CsvField::kStamp, CsvUnit::kNanosecond};
  }
  for (const CsvName& known : kCsvNames) {
    if (!name.starts_with(known.name)) continue;
    const std::string_view rest = std::string_view(name).substr(known.name.size());
    if (rest.empty()) return {known.field, CsvUnit::kBase};
    for (const CsvSuffix& known_suffix : kCsvSuffixes) {
      if (rest == known_suffix.suffix && known_suffix.dimension == known.dimension) {
        return {known.field, known_suffix.unit};
      }
    }
  }
  return {};
}

char separator_of(std::string_view line) {
  for (const char separator : {';', '\t', ','}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return ' ';
}

/// Which column is missing that a scan needs; empty where none is.
std::string fault_of(const CsvColumns& table) {
  const auto has = [&](CsvField field) {
    return std::ranges::find(table.columns, field, &CsvColumn::field) != table.columns.end();
  };
  const auto has_all_or_none = [&](CsvField first, CsvField second, CsvField third) {
    return has(first) == has(second) && has(second) == has(third);
  };
  if (!has(CsvField::kStamp)) return "no column \"stamp\"";
  if (!has(CsvField::kAngleMin)) return "no column \"angle_min\" or \"angle_min_deg\"";
  if (!has(CsvField::kAngleStep)) return "no column \"angle_step\" or \"angle_step_deg\"";
  if (!has(CsvField::kRange)) return "no column \"ranges\" or \"range_0\"";
  const bool has_one = std::ranges::count(table.columns, CsvField::kRange, &CsvColumn::field) == 1;
  if (has_one && !table.is_open_ended) return "the column \"ranges\" must be the last";
  if (!has_all_or_none(CsvField::kOdomX, CsvField::kOdomY, CsvField::kOdomTheta)) {
    return "odometry needs the columns odom_x, odom_y and odom_theta";
  }
  if (!has_all_or_none(CsvField::kMountingX, CsvField::kMountingY, CsvField::kMountingTheta)) {
    return "a mounting needs the columns mounting_x, mounting_y and mounting_theta";
  }
  return {};
}

/// The columns that a line names; nothing where it names none or has numbers in it.
std::optional<CsvColumns> columns_from_header(std::string_view line) {
  CsvColumns table;
  table.separator = separator_of(line);
  table.header = line;
  if (line.starts_with('#')) line.remove_prefix(1);
  CsvFields names(line, table.separator);
  std::size_t num_known = 0;
  while (names.has_next()) {
    const auto name = names.text();
    if (!name || (!name->empty() && number_from_field(*name))) return std::nullopt;
    table.columns.push_back(column_named(*name));
    num_known += table.columns.back().field == CsvField::kOther ? 0 : 1;
  }
  if (num_known < 2) return std::nullopt;
  table.is_open_ended = table.columns.back().field == CsvField::kRange;
  table.fault = fault_of(table);
  return table;
}

/// Whether the numbers of a line can be stamp, angle_min, angle_step and ranges.
bool can_be_scan(const std::vector<double>& numbers) {
  constexpr double kSlack_rad = 1e-3;
  if (numbers.size() < 4) return false;
  const double angle_min_rad = numbers[1];
  const double angle_step_rad = numbers[2];
  const auto num_steps = static_cast<double>(numbers.size() - 4);
  return std::isfinite(numbers[0]) && std::abs(angle_min_rad) <= kTwoPi && angle_step_rad != 0.0 &&
         std::abs(angle_step_rad) * std::max(1.0, num_steps) <= kTwoPi + kSlack_rad;
}

/// The numbers of a line; nothing where it has anything else.
std::optional<std::vector<double>> numbers_of(std::string_view line, char separator) {
  std::vector<double> numbers;
  CsvFields fields(line, separator);
  while (fields.has_next()) {
    const auto number = fields.number();
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

/// The table that lines without a header make up: every line can be a scan of the same scanner, and
/// the stamps differ.
std::optional<CsvColumns> columns_without_header(const std::vector<std::string_view>& lines) {
  if (lines.empty()) return std::nullopt;
  const char separator = separator_of(lines.front());
  std::vector<double> first;
  bool is_stamp_varying = lines.size() == 1;
  for (const std::string_view line : lines) {
    const auto numbers = numbers_of(line, separator);
    if (!numbers || !can_be_scan(*numbers)) return std::nullopt;
    if (first.empty()) first = *numbers;
    if (first[1] != (*numbers)[1] || first[2] != (*numbers)[2]) return std::nullopt;
    is_stamp_varying |= first[0] != (*numbers)[0];
  }
  if (!is_stamp_varying) return std::nullopt;
  CsvColumns table;
  table.separator = separator;
  for (const auto field :
       {CsvField::kStamp, CsvField::kAngleMin, CsvField::kAngleStep, CsvField::kRange}) {
    table.columns.push_back({field, CsvUnit::kBase});
  }
  return table;
}

bool is_blank_line(std::string_view line) {
  return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

}  // namespace

double in_base_unit(double number, CsvUnit unit) {
  switch (unit) {
    case CsvUnit::kBase:
      return number;
    case CsvUnit::kDegree:
      return rad_from_deg(number);
    case CsvUnit::kCentimetre:
      return number / 100.0;
    case CsvUnit::kMillimetre:
    case CsvUnit::kMillisecond:
      return number / 1e3;
    case CsvUnit::kMicrosecond:
      return number / 1e6;
    case CsvUnit::kNanosecond:
      return number / 1e9;
  }
  return number;
}

int num_decimals_of(CsvUnit unit) {
  switch (unit) {
    case CsvUnit::kMillisecond:
      return 3;
    case CsvUnit::kMicrosecond:
      return 6;
    case CsvUnit::kNanosecond:
      return 9;
    default:
      return 0;
  }
}

std::optional<CsvColumns> csv_columns_from(std::string_view beginning) {
  constexpr std::size_t kMaxLines = 10;
  std::vector<std::string_view> lines;
  while (!beginning.empty() && lines.size() < kMaxLines) {
    const std::size_t end = beginning.find('\n');
    std::string_view line = beginning.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    beginning.remove_prefix(end == std::string_view::npos ? beginning.size() : end + 1);
    const bool is_cut = end == std::string_view::npos && !lines.empty();
    if (is_blank_line(line) || is_cut) continue;
    if (lines.empty()) {
      if (auto table = columns_from_header(line)) return table;
    }
    if (line.front() != '#') lines.push_back(line);
  }
  return columns_without_header(lines);
}

}  // namespace setsquare
