// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/csv/fields.hpp"

#include <limits>

#include "setsquare/io/bytes/decimal_number.hpp"

namespace setsquare {

CsvFields::CsvFields(std::string_view line, char separator)
    : next_(line.data()), end_(next_ + line.size()), separator_(separator) {
  skip_blanks();
  has_next_ = separator_ != ' ' || next_ != end_;
}

bool CsvFields::is_blank(char c) const { return c == ' ' || (c == '\t' && separator_ != '\t'); }

void CsvFields::skip_blanks() {
  while (next_ != end_ && is_blank(*next_)) ++next_;
}

bool CsvFields::is_at_separator() const {
  return separator_ == ' ' ? is_blank(*next_) : *next_ == separator_;
}

/// Steps over the separator behind a field; false where other text stands there.
bool CsvFields::finish_field() {
  const char* const field_end = next_;
  skip_blanks();
  has_next_ = next_ != end_;
  if (!has_next_) return true;
  if (separator_ == ' ') return next_ != field_end;
  if (*next_ != separator_) return false;
  ++next_;
  skip_blanks();
  return true;
}

std::optional<std::string_view> CsvFields::quoted() {
  unquoted_.clear();
  for (++next_; next_ != end_; ++next_) {
    if (*next_ == '"') {
      const bool is_doubled = next_ + 1 != end_ && next_[1] == '"';
      if (!is_doubled) break;
      ++next_;
    }
    unquoted_ += *next_;
  }
  if (next_ == end_) return std::nullopt;
  ++next_;
  return finish_field() ? std::optional<std::string_view>(unquoted_) : std::nullopt;
}

std::optional<std::string_view> CsvFields::text() {
  if (next_ != end_ && *next_ == '"') return quoted();
  const char* const first = next_;
  while (next_ != end_ && !is_at_separator()) ++next_;
  const char* last = next_;
  while (last != first && is_blank(last[-1])) --last;
  finish_field();
  return std::string_view(first, static_cast<std::size_t>(last - first));
}

std::optional<double> CsvFields::number() {
  const char* const first = next_;
  double number = 0.0;
  if (const char* const after = read_number(next_, end_, number)) {
    next_ = after;
    if (finish_field()) return number;
    next_ = first;
  }
  const auto field = text();
  return field ? number_from_field(*field) : std::nullopt;
}

std::optional<double> number_from_field(std::string_view field) {
  if (field.empty()) return std::numeric_limits<double>::quiet_NaN();
  return decimal_from_text(field);
}

}  // namespace setsquare
