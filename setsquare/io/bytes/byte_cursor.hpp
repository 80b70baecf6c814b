// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace setsquare {

/// Reads little-endian values off the front of a block of bytes. It never reads beyond the block:
/// the first read that would fail is remembered, and all reads after it give zeros.
class ByteCursor {
 public:
  explicit ByteCursor(std::string_view bytes) : bytes_(bytes) {
    static_assert(std::endian::native == std::endian::little, "byte order of the log formats");
  }

  template <typename Value>
  [[nodiscard]] Value read() {
    Value value{};
    const std::string_view raw = take(sizeof(Value));
    if (!raw.empty()) std::memcpy(&value, raw.data(), sizeof(Value));
    return value;
  }

  [[nodiscard]] bool read_flag() { return read<std::uint8_t>() != 0; }

  /// The next num_bytes bytes; empty where there are fewer.
  [[nodiscard]] std::string_view take(std::size_t num_bytes) {
    if (bytes_.size() - position_ < num_bytes) {
      is_short_ = true;
      position_ = bytes_.size();
      return {};
    }
    const std::string_view taken = bytes_.substr(position_, num_bytes);
    position_ += num_bytes;
    return taken;
  }

  void skip(std::size_t num_bytes) { static_cast<void>(take(num_bytes)); }

  /// Whether a read went beyond the block.
  [[nodiscard]] bool is_short() const { return is_short_; }
  [[nodiscard]] std::size_t position() const { return position_; }

 private:
  std::string_view bytes_;
  std::size_t position_ = 0;
  bool is_short_ = false;
};

}  // namespace setsquare
