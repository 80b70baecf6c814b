// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/angle_distance/row.hpp"

#include <cstddef>

#include "setsquare/io/bytes/decimal_number.hpp"

namespace setsquare {
namespace {

bool is_row_separator(char c) { return c == ' ' || c == '\t' || c == ',' || c == ';' || c == '\r'; }

/// The next word between separators; empty at the end.
std::string_view next_word(std::string_view& text) {
  std::size_t first = 0;
  while (first < text.size() && is_row_separator(text[first])) ++first;
  std::size_t last = first;
  while (last < text.size() && !is_row_separator(text[last])) ++last;
  const std::string_view word = text.substr(first, last - first);
  text.remove_prefix(last);
  return word;
}

}  // namespace

bool read_angle_distance_row(std::string_view line, AngleDistanceRow& row) {
  row.numbers.clear();
  row.starts_revolution = false;
  bool is_first = true;
  for (auto word = next_word(line); !word.empty(); word = next_word(line)) {
    const bool is_mark = is_first && word == "S";
    is_first = false;
    row.starts_revolution |= is_mark;
    const std::size_t colon = word.find(':');
    if (colon != std::string_view::npos) word.remove_prefix(colon + 1);
    if (is_mark || word.empty()) continue;
    const auto number = decimal_from_text(word);
    if (!number) return false;
    row.numbers.push_back(*number);
  }
  return row.numbers.size() >= 2;
}

bool has_angle_distance_rows(std::string_view beginning) {
  constexpr int kMaxLines = 50;
  AngleDistanceRow row;
  for (int i = 0; i < kMaxLines && !beginning.empty(); ++i) {
    const std::size_t end = beginning.find('\n');
    if (read_angle_distance_row(beginning.substr(0, end), row)) return true;
    beginning.remove_prefix(end == std::string_view::npos ? beginning.size() : end + 1);
  }
  return false;
}

}  // namespace setsquare
