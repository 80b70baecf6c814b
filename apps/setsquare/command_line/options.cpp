// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/command_line/options.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>

#include "setsquare/core/joined.hpp"

namespace setsquare::app {
namespace {

/// The whole text as a number; nothing where it is not a number or does not fit.
template <typename Number>
std::optional<Number> number_from_text(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// A check of a number; `expected` says what it should be.
template <typename Number, typename IsGood>
CLI::Validator number_check(const IsGood& is_good, const std::string& expected) {
  return {[=](const std::string& text) {
            const auto number = number_from_text<Number>(text);
            return number && is_good(*number) ? std::string()
                                              : fmt::format("{} is not {}", text, expected);
          },
          ""};
}

/// Whether two words are the same but for upper and lower case.
bool is_same_word(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace

CLI::Validator whole_number(std::uint64_t low, std::uint64_t high) {
  return number_check<std::uint64_t>([=](std::uint64_t n) { return low <= n && n <= high; },
                                     fmt::format("a whole number from {} to {}", low, high));
}

CLI::Validator number_above(double low) {
  return number_check<double>([=](double number) { return number > low && std::isfinite(number); },
                              fmt::format("a number above {}", low));
}

CLI::Validator number_above(double low, double high) {
  return number_check<double>([=](double number) { return number > low && number <= high; },
                              fmt::format("a number above {} and at most {}", low, high));
}

CLI::Validator number_from(double low, double high) {
  return number_check<double>([=](double number) { return number >= low && number <= high; },
                              fmt::format("a number from {} to {}", low, high));
}

CLI::Validator number_not_zero(double high) {
  return number_check<double>(
      [=](double number) { return number != 0.0 && -high <= number && number <= high; },
      fmt::format("a number from {} to {} other than 0", -high, high));
}

CLI::Validator one_of(std::vector<std::string> names) {
  return {[names = std::move(names)](std::string& text) {
            for (const std::string& name : names) {
              if (!is_same_word(name, text)) continue;
              text = name;
              return std::string();
            }
            return fmt::format("'{}' is none of {}", text, joined(names));
          },
          ""};
}

std::string bars_between(const std::vector<std::string>& names) { return joined(names, "|"); }

}  // namespace setsquare::app
