// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/stamp_text.hpp"

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>

#include "setsquare/io/bytes/decimal_number.hpp"
#include "setsquare/io/logs/record_stream.hpp"

namespace setsquare {
namespace {

/// "1234567.5" in ms becomes "1234.5675" in s: the decimal point moves.
std::string with_point_moved(std::string_view text, int num_decimals) {
  const bool is_negative = text.starts_with('-');
  if (is_negative) text.remove_prefix(1);
  const std::size_t point = text.find('.');
  std::string whole(text.substr(0, point));
  const std::string_view rest = point == std::string_view::npos ? "" : text.substr(point + 1);
  const auto num_moved = static_cast<std::size_t>(num_decimals);
  if (whole.size() <= num_moved) whole.insert(0, num_moved + 1 - whole.size(), '0');
  whole.insert(whole.size() - num_moved, 1, '.');
  return (is_negative ? "-" : "") + whole + std::string(rest);
}

std::optional<Timestamp> stamp_from_double(std::string_view text, int num_decimals) {
  const auto number = decimal_from_text(text);
  if (!number) return std::nullopt;
  const double seconds = *number / std::pow(10.0, num_decimals);
  constexpr double kMaxStamp_s = static_cast<double>(kMaxStamp_ns) * 1e-9;
  if (!(std::abs(seconds) <= kMaxStamp_s)) return std::nullopt;
  return timestamp_from_seconds(seconds);
}

}  // namespace

std::string exact_text(Timestamp stamp) {
  std::string text = to_string(Timestamp{stamp.ns - stamp.ns % 1000});
  const auto rest_ns = static_cast<int>(std::abs(stamp.ns % 1000));
  if (rest_ns == 0) return text;
  const bool has_lost_its_sign = stamp.ns < 0 && stamp.ns > -1000;
  return fmt::format("{}{}{:03}", has_lost_its_sign ? "-" : "", text, rest_ns);
}

std::optional<Timestamp> stamp_from_text(std::string_view text, int num_decimals) {
  const bool has_exponent = text.find_first_of("eE") != std::string_view::npos;
  const auto stamp = has_exponent ? stamp_from_double(text, num_decimals)
                     : num_decimals == 0
                         ? timestamp_from_decimal(text)
                         : timestamp_from_decimal(with_point_moved(text, num_decimals));
  return stamp && is_possible(*stamp) ? stamp : std::nullopt;
}

}  // namespace setsquare
