// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Whole numbers as SQLite's files hold them, for the database's pages and for its write-ahead log.
#pragma once

#include <bit>
#include <cassert>
#include <cstdint>
#include <span>

namespace setsquare::sqlite {

/// The number that the first four bytes are.
[[nodiscard]] inline std::uint32_t big_endian_32(std::span<const char> bytes) {
  assert(bytes.size() >= 4);
  std::uint32_t value = 0;
  for (const char byte : bytes.first(4)) value = value << 8 | static_cast<std::uint8_t>(byte);
  return value;
}

/// The same with the bytes the other way round.
[[nodiscard]] inline std::uint32_t little_endian_32(std::span<const char> bytes) {
  const std::uint32_t value = big_endian_32(bytes);
  return value >> 24 | (value >> 8 & 0xff00U) | (value << 8 & 0xff0000U) | value << 24;
}

/// Whether a database can have pages of that many bytes.
[[nodiscard]] inline bool is_page_size(std::uint32_t num_bytes) {
  return std::has_single_bit(num_bytes) && num_bytes >= 512 && num_bytes <= 65536;
}

}  // namespace setsquare::sqlite
