// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// Reads numbers and words, separated by blanks, off the front of a line. Nothing is returned where
/// the next word is missing or is not what was asked for; the position is then undefined.
class TextScanner {
 public:
  explicit TextScanner(std::string_view text) : next_(text.data()), end_(next_ + text.size()) {}

  [[nodiscard]] std::optional<std::string_view> word();
  [[nodiscard]] std::optional<double> number();           ///< "nan" and "inf" included.
  [[nodiscard]] bool numbers(std::span<double> numbers);  ///< As many as there is room for.
  [[nodiscard]] std::optional<double> finite_number();
  [[nodiscard]] std::optional<std::uint32_t> count();
  [[nodiscard]] std::optional<Pose2> pose();  ///< x, y (m), theta (rad), finite.
  [[nodiscard]] bool is_at_end();

 private:
  void skip_blanks();
  [[nodiscard]] bool is_at_word_end() const;

  const char* next_;
  const char* end_;
};

}  // namespace setsquare
