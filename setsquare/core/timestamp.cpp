// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/timestamp.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace setsquare {
namespace {

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;
constexpr std::int64_t kMaxSeconds =
    std::numeric_limits<std::int64_t>::max() / kNanosecondsPerSecond - 1;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Nanoseconds of the digits behind the decimal point; nothing where one is not a digit.
std::optional<std::int64_t> nanoseconds_from_fraction(std::string_view digits) {
  std::int64_t ns = 0;
  std::int64_t unit = kNanosecondsPerSecond;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (!is_digit(digits[i])) return std::nullopt;
    unit /= 10;
    if (i < 9) ns += (digits[i] - '0') * unit;
    if (i == 9 && digits[i] >= '5') ++ns;
  }
  return ns;
}

}  // namespace

std::optional<Timestamp> timestamp_from_decimal(std::string_view text) {
  const bool is_negative = text.starts_with('-');
  if (is_negative) text.remove_prefix(1);
  const std::size_t point = text.find('.');
  const std::string_view whole = text.substr(0, point);
  if (whole.empty() || !is_digit(whole.front())) return std::nullopt;
  std::int64_t seconds = 0;
  const auto [end, error] = std::from_chars(whole.data(), whole.data() + whole.size(), seconds);
  if (error != std::errc{} || end != whole.data() + whole.size() || seconds > kMaxSeconds) {
    return std::nullopt;
  }
  std::optional<std::int64_t> fraction_ns = 0;
  if (point != std::string_view::npos) {
    fraction_ns = nanoseconds_from_fraction(text.substr(point + 1));
  }
  if (!fraction_ns) return std::nullopt;
  const std::int64_t ns = seconds * kNanosecondsPerSecond + *fraction_ns;
  return Timestamp{is_negative ? -ns : ns};
}

std::optional<Timestamp> timestamp_from_decimal(std::string_view text, StampUnit unit) {
  constexpr std::size_t kMostDigits = 64;
  if (unit == StampUnit::kSeconds) return timestamp_from_decimal(text);
  const bool is_negative = text.starts_with('-');
  if (is_negative) text.remove_prefix(1);
  if (text.size() > kMostDigits || text.empty() || !is_digit(text.front())) return std::nullopt;
  const auto shift = static_cast<std::size_t>(unit);
  const std::size_t point = std::min(text.find('.'), text.size());
  std::string whole(text.substr(0, point));
  if (whole.size() <= shift) whole.insert(0, shift + 1 - whole.size(), '0');
  std::string seconds = is_negative ? "-" : "";
  seconds += whole.substr(0, whole.size() - shift) + "." + whole.substr(whole.size() - shift);
  if (point < text.size()) seconds += text.substr(point + 1);
  return timestamp_from_decimal(seconds);
}

Timestamp timestamp_from_seconds(double seconds) {
  const double whole = std::floor(seconds);
  const auto fraction_ns =
      std::llround((seconds - whole) * static_cast<double>(kNanosecondsPerSecond));
  return {static_cast<std::int64_t>(whole) * kNanosecondsPerSecond + fraction_ns};
}

std::string to_string(Timestamp stamp) {
  const bool is_negative = stamp.ns < 0;
  const std::uint64_t magnitude_ns = is_negative
                                         ? std::uint64_t{0} - static_cast<std::uint64_t>(stamp.ns)
                                         : static_cast<std::uint64_t>(stamp.ns);
  const std::uint64_t us = magnitude_ns / 1000 + (magnitude_ns % 1000 >= 500 ? 1 : 0);
  return fmt::format(
      "{}{}.{:06}", is_negative && us != 0 ? "-" : "", us / 1'000'000, us % 1'000'000);
}

}  // namespace setsquare
