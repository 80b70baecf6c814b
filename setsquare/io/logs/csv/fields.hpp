// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace setsquare {

/// Reads the fields of one line of a table in order. A separator of ' ' stands for any blanks, of
/// which several are one. Blanks around a field do not count. A field may stand in double quotes,
/// a quote within doubled (RFC 4180). Once a read has failed the position is undefined.
class CsvFields {
 public:
  CsvFields(std::string_view line, char separator);

  /// Whether there is another field. An empty line has one, as RFC 4180 has it, but none where
  /// blanks separate.
  [[nodiscard]] bool has_next() const { return has_next_; }

  /// The next field, without its quotes, valid until the next call; nothing where a quote stays
  /// open or text follows its end.
  [[nodiscard]] std::optional<std::string_view> text();

  /// The next field as a number, NaN where it is empty; nothing where it is no number.
  [[nodiscard]] std::optional<double> number();

 private:
  void skip_blanks();
  [[nodiscard]] bool is_blank(char c) const;
  [[nodiscard]] bool is_at_separator() const;
  bool finish_field();
  [[nodiscard]] std::optional<std::string_view> quoted();

  const char* next_;
  const char* end_;
  char separator_;
  bool has_next_ = true;
  std::string unquoted_;
};

/// A field's text as a number, a plus sign allowed, NaN where it is empty; nothing where it is no
/// number.
[[nodiscard]] std::optional<double> number_from_field(std::string_view field);

}  // namespace setsquare
