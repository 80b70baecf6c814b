// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "setsquare/io/bags/message_source.hpp"

namespace setsquare::ros {

/// Turns a value's bytes round.
template <typename Value>
[[nodiscard]] Value with_bytes_reversed(Value value) {
  char bytes[sizeof(Value)];
  std::memcpy(bytes, &value, sizeof(Value));
  std::reverse(bytes, bytes + sizeof(Value));
  std::memcpy(&value, bytes, sizeof(Value));
  return value;
}

/// Reads values off the front of a serialised message.
///
/// CDR (OMG DDS-RTPS 2.3, section 10; XCDR version 1): a header of four bytes names the byte order;
/// behind it each value begins at a multiple of its size; strings count their closing zero. ROS 1
/// serialisation is the same without header, gaps and closing zeros, always little-endian.
///
/// It never reads beyond the message: the first read that fails is remembered in failure(), and all
/// reads after it give zeros.
class WireReader {
 public:
  WireReader(std::string_view message, MessageEncoding encoding);

  template <typename Value>
  [[nodiscard]] Value read() {
    align(sizeof(Value));
    Value value{};
    const std::string_view raw = take(sizeof(Value));
    if (raw.empty()) return value;
    std::memcpy(&value, raw.data(), sizeof(Value));
    return is_swapped_ ? with_bytes_reversed(value) : value;
  }

  /// A string, without its closing zero.
  [[nodiscard]] std::string_view read_text();

  /// The number of elements of a sequence, each of at least min_element_bytes. A number that the
  /// rest of the message cannot hold is a failure.
  [[nodiscard]] std::size_t read_count(std::size_t min_element_bytes);

  /// Whether the rest of the message can hold so many elements; where not, that is a failure.
  bool has_room_for(std::size_t num_elements, std::size_t min_element_bytes);

  /// The bytes of num_elements numbers of this size, in the message's byte order.
  [[nodiscard]] std::string_view read_array(std::size_t num_elements, std::size_t element_bytes) {
    if (num_elements == 0 || !has_room_for(num_elements, element_bytes)) return {};
    align(element_bytes);
    return take(num_elements * element_bytes);
  }

  /// Steps over bytes that begin at a multiple of `alignment` (1, 2, 4 or 8).
  void skip(std::size_t alignment, std::size_t num_bytes) {
    align(alignment);
    static_cast<void>(take(num_bytes));
  }

  /// Whether the bytes of read_array are in the other byte order than this machine's.
  [[nodiscard]] bool is_swapped() const { return is_swapped_; }
  [[nodiscard]] bool has_failed() const { return !failure_.empty(); }
  /// Why the message cannot be read; empty as long as it can.
  [[nodiscard]] std::string_view failure() const { return failure_; }
  [[nodiscard]] std::size_t num_left() const { return body_.size() - position_; }

 private:
  void read_cdr_header();
  /// Gaps count from the start of the body, behind the header.
  void align(std::size_t alignment) {
    const std::size_t mask = std::min(alignment, max_alignment_) - 1;
    position_ = std::min((position_ + mask) & ~mask, body_.size());
  }
  [[nodiscard]] std::string_view take(std::size_t num_bytes);
  void fail(std::string_view reason);

  std::string_view body_;
  std::size_t position_ = 0;
  std::size_t max_alignment_ = 1;
  bool is_swapped_ = false;
  bool has_closing_zeros_ = false;
  std::string_view failure_;
};

}  // namespace setsquare::ros
