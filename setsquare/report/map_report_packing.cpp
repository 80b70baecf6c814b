// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map_report_packing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace setsquare {

std::string base64(std::string_view bytes) {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t first = 0; first < bytes.size(); first += 3) {
    const std::size_t num_bytes = std::min<std::size_t>(3, bytes.size() - first);
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool is_there = i < num_bytes;
      group = group << 8 | (is_there ? static_cast<unsigned char>(bytes[first + i]) : 0U);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      text += i <= num_bytes ? kLetters[group >> (18 - 6 * i) & 63U] : '=';
    }
  }
  return text;
}

std::int64_t quantised(double value, double step) {
  constexpr double kLargest = 1125899906842624.0;  // 2^50
  const double steps = value / step;
  if (std::isnan(steps)) return 0;
  return std::llround(std::clamp(steps, -kLargest, kLargest));
}

std::string packed(std::span<const std::int64_t> values) {
  std::string bytes;
  bytes.reserve(2 * values.size());
  std::int64_t previous = 0;
  for (const std::int64_t value : values) {
    const std::int64_t step = value - previous;
    const auto doubled = static_cast<std::uint64_t>(step) << 1;
    std::uint64_t folded = step < 0 ? ~doubled : doubled;
    for (; folded >= 128; folded >>= 7) bytes += static_cast<char>((folded & 127) | 128);
    bytes += static_cast<char>(folded);
    previous = value;
  }
  return base64(bytes);
}

}  // namespace setsquare
