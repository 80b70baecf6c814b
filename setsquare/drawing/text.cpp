// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/drawing/text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <utility>

namespace setsquare {
namespace {

constexpr std::array<std::pair<char, std::string_view>, 5> kEntities = {
    {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}}};

/// Bytes of the first character; 0 where it is no UTF-8, or nothing that XML 1.0 allows.
std::size_t length_of_character(std::string_view text) {
  const auto first = static_cast<unsigned char>(text.front());
  if (first < 0x80) return (first >= 0x20 && first != 0x7f) || first == '\n' ? 1 : 0;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < length) return 0;
  std::uint32_t code = first & (0xffU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xc0U) != 0x80U) return 0;
    code = code << 6 | (byte & 0x3fU);
  }
  constexpr std::array<std::uint32_t, 5> kSmallest = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xd800 && code <= 0xdfff;
  const bool is_control = code < 0xa0;
  const bool is_allowed = code >= kSmallest[length] && code <= 0x10ffff && !is_surrogate &&
                          !is_control && code != 0xfffe && code != 0xffff;
  return is_allowed ? length : 0;
}

}  // namespace

std::string fixed(double value, int num_decimals) {
  assert(num_decimals >= 0 && num_decimals <= 9);
  std::string text = fmt::format("{:.{}f}", value, num_decimals);
  const bool is_zero = text.find_first_not_of("-0.") == std::string::npos;
  if (is_zero && text.front() == '-') text.erase(0, 1);
  return text;
}

std::string escape_xml(std::string_view text) {
  constexpr std::string_view kReplacement = "\xef\xbf\xbd";  // U+FFFD
  std::string escaped;
  escaped.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = length_of_character(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(1, length));
    const auto entity = std::find_if(kEntities.begin(), kEntities.end(), [&](const auto& entry) {
      return character.front() == entry.first;
    });
    if (entity != kEntities.end()) {
      escaped += entity->second;
    } else {
      escaped += length > 0 ? character : kReplacement;
    }
    text.remove_prefix(character.size());
  }
  return escaped;
}

}  // namespace setsquare
