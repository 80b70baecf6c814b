// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/json_lines/scanner.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "setsquare/io/bytes/decimal_number.hpp"

namespace setsquare {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// Whether a character ends a number, a name or a word such as null.
bool is_json_delimiter(char c) {
  return c == ',' || c == ']' || c == '}' || c == ':' || c == ' ' || c == '\t' || c == '\r';
}

/// How many characters the escape at the front takes: `\n`, `\u00e4`.
std::size_t escape_length(std::string_view text) {
  return text.size() > 1 && text[1] == 'u' ? 6 : 2;
}

/// The text between quotes as it is meant; nothing where an escape is none. Beside the escapes it
/// may be in any encoding.
std::optional<std::string> unescaped(std::string_view text) {
  std::string plain;
  for (;;) {
    const std::size_t first = std::min(text.find('\\'), text.size());
    plain += text.substr(0, first);
    text.remove_prefix(first);
    if (text.empty()) return plain;
    std::size_t length = 0;  // Of all in a row: two may be one character.
    while (length < text.size() && text[length] == '\\') {
      length += escape_length(text.substr(length));
    }
    const auto value = nlohmann::ordered_json::parse(
        fmt::format("\"{}\"", text.substr(0, length)), nullptr, false);
    if (!value.is_string()) return std::nullopt;
    plain += value.get<std::string>();
    text.remove_prefix(std::min(length, text.size()));
  }
}

}  // namespace

void JsonScanner::skip_blanks() {
  while (next_ != end_ && (*next_ == ' ' || *next_ == '\t' || *next_ == '\r')) ++next_;
}

bool JsonScanner::take(char c) {
  skip_blanks();
  if (next_ == end_ || *next_ != c) return false;
  ++next_;
  return true;
}

bool JsonScanner::is_at_end() {
  skip_blanks();
  return next_ == end_;
}

bool JsonScanner::take_null() {
  constexpr std::string_view kNull = "null";
  skip_blanks();
  if (!std::string_view(next_, static_cast<std::size_t>(end_ - next_)).starts_with(kNull)) {
    return false;
  }
  next_ += kNull.size();
  return true;
}

/// The text of a string with its quotes and escapes.
std::optional<std::string_view> JsonScanner::quoted_text() {
  skip_blanks();
  const char* const first = next_;
  if (next_ == end_ || *next_ != '"') return std::nullopt;
  for (++next_; next_ != end_ && *next_ != '"'; ++next_) {
    if (*next_ == '\\' && ++next_ == end_) return std::nullopt;
  }
  if (next_ == end_) return std::nullopt;
  ++next_;
  return std::string_view(first, static_cast<std::size_t>(next_ - first));
}

std::optional<std::string> JsonScanner::string() {
  const auto quoted = quoted_text();
  if (!quoted) return std::nullopt;
  return unescaped(quoted->substr(1, quoted->size() - 2));
}

std::optional<double> JsonScanner::number() {
  skip_blanks();
  double number = kNoNumber;
  if (const char* const after = read_number(next_, end_, number)) {
    next_ = after;
    return number;
  }
  if (take_null()) return kNoNumber;
  const auto quoted = quoted_text();
  if (!quoted) return std::nullopt;
  return decimal_from_text(quoted->substr(1, quoted->size() - 2));
}

std::optional<std::string_view> JsonScanner::number_text() {
  skip_blanks();
  const char* const first = next_;
  while (next_ != end_ && !is_json_delimiter(*next_)) ++next_;
  if (next_ == first) return std::nullopt;
  return std::string_view(first, static_cast<std::size_t>(next_ - first));
}

bool JsonScanner::numbers(std::vector<double>& numbers, std::size_t max_count) {
  if (!take('[')) return false;
  if (take(']')) return true;
  do {
    const auto read = number();
    if (!read || numbers.size() == max_count) return false;
    numbers.push_back(*read);
  } while (take(','));
  return take(']');
}

bool JsonScanner::skip_value() {
  skip_blanks();
  std::size_t depth = 0;
  do {
    skip_blanks();
    if (next_ == end_) return false;
    const char c = *next_;
    if (c == '"') {
      if (!quoted_text()) return false;
    } else if (c == '[' || c == '{') {
      ++depth;
      ++next_;
    } else if (c == ']' || c == '}') {
      if (depth == 0) return false;
      --depth;
      ++next_;
    } else if (depth > 0 && (c == ',' || c == ':')) {
      ++next_;
    } else if (!number_text()) {
      return false;
    }
  } while (depth > 0);
  return true;
}

}  // namespace setsquare
