// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace setsquare {

/// Appends as few digits as read back to the same number, whatever the locale. By std::to_chars,
/// since fmt::format("{}") gives another form of some numbers (100000 for 1e+05).
template <typename Number>
void append_shortest(std::string& text, Number number) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  text.append(digits.data(), end);
}

}  // namespace setsquare
