// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "setsquare/io/logs/csv/columns.hpp"
#include "setsquare/io/logs/line_log.hpp"

namespace setsquare {

class CsvFields;  // setsquare/io/logs/csv/fields.hpp

/// The scans of a table: one per line, csv_columns_from() says how the columns lie. Ranges in m,
/// as many as the line has; an empty field is NaN.
class CsvLog final : public LineLog {
 public:
  /// Throws FormatError naming `name` where the text is no table of scans or lacks a column.
  CsvLog(std::unique_ptr<InputBuffer> input, const std::string& name);

  double mounting_rounding() const override { return 0.0; }
  std::string format() const override { return "table of scans (CSV)"; }

 protected:
  LineOutcome read_line(std::string_view line, LogRecord& record) override;
  std::string reason(std::string_view line) const override;

 private:
  [[nodiscard]] bool read_fields(std::string_view line, LogRecord& record);
  [[nodiscard]] bool read_field(const CsvColumn& column, CsvFields& fields, LogRecord& record);
  [[nodiscard]] bool fill(LogRecord& record);
  [[nodiscard]] double number(CsvField field) const {
    return numbers_[static_cast<std::size_t>(field)];
  }
  [[nodiscard]] bool is_cut(std::string_view line, const Scan& scan);
  bool fail(std::string_view reason);

  CsvColumns table_;
  std::array<double, kNumCsvFields> numbers_{};  ///< Of this line, in base units; NaN: not stated.
  std::size_t num_ranges_before_ = 0;            ///< In the last scan.
  std::string_view reason_;                      ///< Static text.
};

}  // namespace setsquare
