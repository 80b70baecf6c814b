// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "setsquare/core/error.hpp"
#include "setsquare/core/timestamp.hpp"
#include "setsquare/io/bytes/line_reader.hpp"
#include "setsquare/io/bytes/text_beginning.hpp"
#include "setsquare/io/bytes/text_scanner.hpp"
#include "setsquare/io/logs/record_stream.hpp"

namespace setsquare {

/// One line of a table of numbers: `num_stamps` stamps, then `num_values` finite numbers, nothing
/// else.
template <std::size_t num_stamps, std::size_t num_values>
struct TableRow {
  std::array<Timestamp, num_stamps> stamps;
  std::array<double, num_values> values;
};

/// Reads one row; nothing where the line is no such row.
template <std::size_t num_stamps, std::size_t num_values>
[[nodiscard]] std::optional<TableRow<num_stamps, num_values>> read_row(std::string_view line) {
  TableRow<num_stamps, num_values> row{};
  TextScanner text(line);
  for (Timestamp& stamp : row.stamps) {
    const auto word = text.word();
    const auto read = word ? timestamp_from_decimal(*word) : std::nullopt;
    if (!read || !is_possible(*read)) return std::nullopt;
    stamp = *read;
  }
  for (double& value : row.values) {
    const auto read = text.finite_number();
    if (!read) return std::nullopt;
    value = *read;
  }
  if (!text.is_at_end()) return std::nullopt;
  return row;
}

/// Calls use(row) for each row of a text, skipping empty lines and comments (#). Throws
/// FormatError naming the first line that is no such row and what a row is; also where the text has
/// no row at all or its gzip stream is damaged.
template <std::size_t num_stamps, std::size_t num_values, typename Use>
void for_each_row(std::unique_ptr<ByteSource> source,
                  const std::string& name,
                  const std::string& row_description,
                  const Use& use) {
  InputBuffer input(unpack(std::move(source)));
  begin_text(input, name);
  LineReader lines(input);
  bool is_empty = true;
  while (const auto line = lines.next()) {
    if (TextScanner(*line).is_at_end() || line->front() == '#') continue;
    const auto row = read_row<num_stamps, num_values>(*line);
    if (!row) {
      throw FormatError(
          name, "line " + std::to_string(lines.line_number()), "expected " + row_description);
    }
    use(*row);
    is_empty = false;
  }
  const std::string damage = input.source().damage();
  if (!damage.empty()) throw FormatError(name, "", damage);
  if (is_empty) throw FormatError(name, "", "no line of " + row_description);
}

}  // namespace setsquare
