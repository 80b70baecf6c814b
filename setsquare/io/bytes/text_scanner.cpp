// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/text_scanner.hpp"

#include <charconv>
#include <cmath>

#include "setsquare/io/bytes/decimal_number.hpp"

namespace setsquare {
namespace {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

}  // namespace

void TextScanner::skip_blanks() {
  while (next_ != end_ && is_blank(*next_)) ++next_;
}

bool TextScanner::is_at_word_end() const { return next_ == end_ || is_blank(*next_); }

bool TextScanner::is_at_end() {
  skip_blanks();
  return next_ == end_;
}

std::optional<std::string_view> TextScanner::word() {
  skip_blanks();
  const char* const first = next_;
  while (!is_at_word_end()) ++next_;
  if (next_ == first) return std::nullopt;
  return std::string_view(first, static_cast<std::size_t>(next_ - first));
}

bool TextScanner::numbers(std::span<double> numbers) {
  for (double& number : numbers) {
    skip_blanks();
    const char* const after = read_number(next_, end_, number);
    if (after == nullptr) return false;
    next_ = after;
    if (!is_at_word_end()) return false;
  }
  return true;
}

std::optional<double> TextScanner::number() {
  double value = 0.0;
  return numbers({&value, 1}) ? std::optional(value) : std::nullopt;
}

std::optional<double> TextScanner::finite_number() {
  const std::optional<double> value = number();
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::uint32_t> TextScanner::count() {
  skip_blanks();
  std::uint32_t value = 0;
  const auto [after, error] = std::from_chars(next_, end_, value);
  next_ = after;
  if (error != std::errc{} || !is_at_word_end()) return std::nullopt;
  return value;
}

std::optional<Pose2> TextScanner::pose() {
  const auto x_m = finite_number();
  const auto y_m = finite_number();
  const auto theta_rad = finite_number();
  if (!x_m || !y_m || !theta_rad) return std::nullopt;
  return Pose2{*x_m, *y_m, *theta_rad};
}

}  // namespace setsquare
