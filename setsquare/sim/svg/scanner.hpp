// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string_view>

namespace setsquare {

/// What is wrong with one attribute or element of an SVG; the caller that walks the document adds
/// the place.
class SvgFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads the small languages inside SVG's attributes (paths, points, transforms) from the left:
/// numbers that may touch each other ("1.5.5-2"), separated by blanks and commas or not at all.
class SvgScanner {
 public:
  explicit SvgScanner(std::string_view text) : rest_(text) {}

  /// Whether nothing but separators is left.
  [[nodiscard]] bool is_at_end();
  /// The next character behind separators, 0 at the end.
  [[nodiscard]] char peek();
  /// Whether what comes next begins a number.
  [[nodiscard]] bool is_at_number();
  /// Takes the next character. Throws SvgFault at the end.
  char take();
  /// A finite number. Throws SvgFault.
  [[nodiscard]] double number();
  /// "0" or "1", which may touch what follows. Throws SvgFault.
  [[nodiscard]] bool flag();
  /// Letters, perhaps none.
  [[nodiscard]] std::string_view word();

 private:
  void skip_separators();

  std::string_view rest_;
};

/// A length in user units: a number, perhaps with "px". Throws SvgFault for other units.
[[nodiscard]] double length_from_svg(std::string_view text);

}  // namespace setsquare
