// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace setsquare {

/// What a column of a table of scans holds.
enum class CsvField {
  kStamp,
  kSensor,
  kAngleMin,
  kAngleStep,
  kRangeMin,
  kRangeMax,
  kTimeIncrement,
  kScanTime,
  kOdomX,
  kOdomY,
  kOdomTheta,
  kMountingX,
  kMountingY,
  kMountingTheta,
  kRange,
  kOther,
};

inline constexpr std::size_t kNumCsvFields = static_cast<std::size_t>(CsvField::kOther) + 1;

/// In which unit a column is written.
enum class CsvUnit {
  kBase,  ///< m, rad, s.
  kDegree,
  kCentimetre,
  kMillimetre,
  kMillisecond,
  kMicrosecond,
  kNanosecond,
};

struct CsvColumn {
  CsvField field = CsvField::kOther;
  CsvUnit unit = CsvUnit::kBase;
};

/// How a table of scans is laid out.
struct CsvColumns {
  char separator = ',';  ///< ' ' for any number of blanks.
  std::vector<CsvColumn> columns;
  /// The last column is one of ranges: the line's further fields are ranges, too.
  bool is_open_ended = true;
  std::string header;  ///< The line that names the columns; empty where none does.
  std::string fault;   ///< Why no scan can be read from it; empty where it can.
};

/// A number in m, rad or s; not for stamps, which need more digits than a double has.
[[nodiscard]] double in_base_unit(double number, CsvUnit unit);

/// How many decimals of a second the unit is: 9 for ns.
[[nodiscard]] int num_decimals_of(CsvUnit unit);

/// Finds out from a text's beginning whether it is a table of scans and how it is laid out. Either
/// a line names the columns ("stamp,angle_min,angle_step,ranges", in any order, see
/// docs/formats.md, also as a comment), or all lines are numbers that can be a stamp, two angles
/// and ranges. Nothing where it is no such table.
[[nodiscard]] std::optional<CsvColumns> csv_columns_from(std::string_view beginning);

[[nodiscard]] inline bool is_csv_log(std::string_view beginning) {
  return csv_columns_from(beginning).has_value();
}

}  // namespace setsquare
