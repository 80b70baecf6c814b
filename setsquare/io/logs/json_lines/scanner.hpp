// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace setsquare {

/// Reads JSON values off the front of a text in order, without a tree of them. Numbers may also be
/// what programs write that JSON has no number for: null, NaN, Infinity, or the same as text
/// ("nan", "inf", "-inf"). Once a read has failed the position is undefined.
class JsonScanner {
 public:
  explicit JsonScanner(std::string_view text) : next_(text.data()), end_(next_ + text.size()) {}

  /// Takes the next character behind blanks where it is `c`.
  [[nodiscard]] bool take(char c);
  [[nodiscard]] bool is_at_end();

  [[nodiscard]] std::optional<std::string> string();
  [[nodiscard]] std::optional<double> number();  ///< NaN for null.

  /// A number as it is written.
  [[nodiscard]] std::optional<std::string_view> number_text();

  /// Appends the numbers of an array; false where it is none or has more than `max_count`.
  [[nodiscard]] bool numbers(std::vector<double>& numbers, std::size_t max_count);

  [[nodiscard]] bool take_null();

  /// Steps over any value. Of its inner structure only brackets and quotes are looked at.
  [[nodiscard]] bool skip_value();

 private:
  void skip_blanks();
  [[nodiscard]] std::optional<std::string_view> quoted_text();

  const char* next_;
  const char* end_;
};

}  // namespace setsquare
