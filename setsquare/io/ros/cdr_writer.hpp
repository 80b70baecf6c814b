// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace setsquare::ros {

/// Writes values one behind the other as CDR (XCDR version 1, little-endian, header 00 01 00 00),
/// the form that WireReader reads and that ROS 2 sends.
class CdrWriter {
 public:
  CdrWriter() {
    static_assert(std::endian::native == std::endian::little, "byte order of ROS messages");
    start();
  }

  /// Begins a new message; the memory of the last is used again.
  void start() { message_.assign({0, 1, 0, 0}); }

  template <typename Value>
  void write(Value value) {
    align(sizeof(Value));
    append(&value, sizeof(Value));
  }

  /// A string, its closing zero counted.
  void write_text(std::string_view text) {
    write_count(text.size() + 1);
    message_.append(text);
    message_.push_back('\0');
  }

  /// The number of elements of a sequence whose elements follow.
  void write_count(std::size_t num_elements) { write(static_cast<std::uint32_t>(num_elements)); }

  /// A whole sequence of numbers.
  template <typename Value>
  void write_sequence(std::span<const Value> values) {
    write_count(values.size());
    if (values.empty()) return;
    align(sizeof(Value));
    append(values.data(), values.size_bytes());
  }

  /// The message so far, header included; valid until the next call.
  [[nodiscard]] const std::string& message() const { return message_; }

 private:
  static constexpr std::size_t kHeaderBytes = 4;

  void align(std::size_t alignment) {
    const std::size_t behind = (message_.size() - kHeaderBytes) % alignment;
    if (behind != 0) message_.append(alignment - behind, '\0');
  }
  void append(const void* bytes, std::size_t num_bytes) {
    message_.append(static_cast<const char*>(bytes), num_bytes);
  }

  std::string message_;
};

}  // namespace setsquare::ros
