// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/svg/scanner.hpp"

#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

namespace setsquare {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// A few characters of the text, for a message.
std::string shown(std::string_view text) {
  constexpr std::size_t kMaxShown = 20;
  std::string words = "\"";
  for (const char c : text.substr(0, kMaxShown)) words += c >= ' ' && c <= '~' ? c : '?';
  return words + "\"";
}

}  // namespace

void SvgScanner::skip_separators() {
  const std::size_t begin = rest_.find_first_not_of(" \t\r\n\f,");
  rest_.remove_prefix(begin == std::string_view::npos ? rest_.size() : begin);
}

bool SvgScanner::is_at_end() {
  skip_separators();
  return rest_.empty();
}

char SvgScanner::peek() {
  skip_separators();
  return rest_.empty() ? '\0' : rest_.front();
}

bool SvgScanner::is_at_number() {
  const char next = peek();
  return is_digit(next) || next == '-' || next == '+' || next == '.';
}

char SvgScanner::take() {
  if (is_at_end()) throw SvgFault("it ends too early");
  const char taken = rest_.front();
  rest_.remove_prefix(1);
  return taken;
}

double SvgScanner::number() {
  if (is_at_end()) throw SvgFault("a number is missing at the end");
  std::string_view text = rest_;
  if (text.front() == '+') text.remove_prefix(1);
  const std::size_t sign = text.starts_with('-') ? 1 : 0;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  // "inf" and "nan" are numbers to from_chars, not to SVG; so would "+-1" be.
  const bool begins_well = text.size() > sign && (is_digit(text[sign]) || text[sign] == '.') &&
                           !(sign == 1 && rest_.front() == '+');
  if (error != std::errc{} || !begins_well || !std::isfinite(value)) {
    throw SvgFault(shown(rest_) + " where a number should be");
  }
  rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
  return value;
}

bool SvgScanner::flag() {
  if (is_at_end()) throw SvgFault("a flag is missing at the end");
  if (rest_.front() != '0' && rest_.front() != '1') {
    throw SvgFault(shown(rest_) + " where a flag, 0 or 1, should be");
  }
  return take() == '1';
}

std::string_view SvgScanner::word() {
  skip_separators();
  std::size_t length = 0;
  while (length < rest_.size() && is_letter(rest_[length])) ++length;
  const std::string_view letters = rest_.substr(0, length);
  rest_.remove_prefix(length);
  return letters;
}

double length_from_svg(std::string_view text) {
  SvgScanner scanner(text);
  const double length = scanner.number();
  const std::string_view unit = scanner.word();
  if ((!unit.empty() && unit != "px") || !scanner.is_at_end()) {
    throw SvgFault(shown(text) + " is no length in user units");
  }
  return length;
}

}  // namespace setsquare
