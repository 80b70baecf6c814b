// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace setsquare {

/// Writes little-endian values one behind the other, as ByteCursor reads them.
class ByteWriter {
 public:
  template <typename Value>
  void write(Value value) {
    static_assert(std::endian::native == std::endian::little, "byte order of the formats");
    static_assert(std::is_arithmetic_v<Value>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(Value));
  }

  void append(std::string_view bytes) { bytes_.append(bytes); }

  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  /// All that was written; the writer is empty then.
  [[nodiscard]] std::string take() { return std::exchange(bytes_, {}); }

 private:
  std::string bytes_;
};

}  // namespace setsquare
