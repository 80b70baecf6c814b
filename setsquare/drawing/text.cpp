// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/drawing/text.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <system_error>

namespace setsquare {

std::string joined(std::initializer_list<std::string_view> pieces) {
  std::string text;
  for (const std::string_view piece : pieces) text += piece;
  return text;
}

std::string fixed(double value, int num_decimals) {
  assert(num_decimals >= 0 && num_decimals <= 9);
  char buffer[400];
  const auto [end, error] =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, num_decimals);
  assert(error == std::errc{});
  std::string_view text(buffer, static_cast<std::size_t>(end - buffer));
  const bool is_zero = text.find_first_not_of("-0.") == std::string_view::npos;
  if (is_zero && text.front() == '-') text.remove_prefix(1);
  return std::string(text);
}

std::string escape_xml(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (const char character : text) {
    if (character == '&') {
      escaped += "&amp;";
    } else if (character == '<') {
      escaped += "&lt;";
    } else if (character == '>') {
      escaped += "&gt;";
    } else if (character == '"') {
      escaped += "&quot;";
    } else if (character == '\'') {
      escaped += "&#39;";
    } else {
      const bool is_allowed = (character >= ' ' && character <= '~') || character == '\n';
      escaped += is_allowed ? character : '?';
    }
  }
  return escaped;
}

}  // namespace setsquare
