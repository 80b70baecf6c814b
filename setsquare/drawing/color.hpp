// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace setsquare {

/// A colour of the sRGB space, one byte a channel.
struct Color {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  bool operator==(const Color&) const = default;
};

/// color(0x3366cc): red 0x33, green 0x66, blue 0xcc.
[[nodiscard]] constexpr Color color(std::uint32_t rgb) {
  return {static_cast<std::uint8_t>((rgb >> 16) & 0xffU),
          static_cast<std::uint8_t>((rgb >> 8) & 0xffU),
          static_cast<std::uint8_t>(rgb & 0xffU)};
}

/// The colour at `share` (0 to 1) of the way from one to another, rounded a channel.
[[nodiscard]] constexpr Color mix(Color from, Color to, double share) {
  const auto channel = [share](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(a + (static_cast<double>(b) - a) * share + 0.5);
  };
  return {channel(from.red, to.red), channel(from.green, to.green), channel(from.blue, to.blue)};
}

}  // namespace setsquare
