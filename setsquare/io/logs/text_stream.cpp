// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/text_stream.hpp"

#include <string_view>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/io/logs/angle_distance/log.hpp"
#include "setsquare/io/logs/carmen/log.hpp"
#include "setsquare/io/logs/csv/log.hpp"
#include "setsquare/io/logs/json_lines/log.hpp"

namespace setsquare {
namespace {

constexpr std::string_view kRowsWithoutMeaning =
    "rows of numbers that do not say what they are. Angles and distances: --layout pairs (a line "
    "is "
    "a beam) or revolutions, with --angle-unit, --range-unit, --scan-rate, --clockwise. Scans: a "
    "first line \"stamp,angle_min,angle_step,ranges\"";

}  // namespace

std::unique_ptr<RecordStream> open_text_stream(std::unique_ptr<InputBuffer>& input,
                                               const std::string& name,
                                               const LogOptions& options) {
  const std::string_view beginning = input->available();
  if (is_carmen_log(beginning)) return std::make_unique<CarmenLog>(std::move(input), options);
  if (is_json_lines_log(beginning)) {
    return std::make_unique<JsonLinesLog>(std::move(input), options);
  }
  const auto table = csv_columns_from(beginning);
  const bool names_its_columns = table && !table->header.empty();
  const bool are_rows = has_angle_distance_rows(beginning);
  if (are_rows && options.angle_distance && !names_its_columns) {
    return std::make_unique<AngleDistanceLog>(std::move(input), *options.angle_distance);
  }
  if (table) return std::make_unique<CsvLog>(std::move(input), name);
  if (are_rows) throw FormatError(name, "", std::string(kRowsWithoutMeaning));
  if (beginning.starts_with('{') || beginning.starts_with('[')) {
    throw FormatError(name, "", "JSON, but not of one object per line");
  }
  return nullptr;
}

}  // namespace setsquare
