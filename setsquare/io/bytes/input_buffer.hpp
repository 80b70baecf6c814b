// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "setsquare/io/bytes/byte_source.hpp"

namespace setsquare {

/// A window on a byte source: the unread bytes that are in memory, contiguous, however the source
/// delivers them. Memory is bounded by the largest size that ensure() is asked for.
class InputBuffer {
 public:
  explicit InputBuffer(std::unique_ptr<ByteSource> source);

  /// The unread bytes in memory. Valid until the next ensure() or fill().
  [[nodiscard]] std::string_view available() const {
    return {bytes_.data() + begin_, end_ - begin_};
  }

  /// Reads until at least num_bytes are available; false where the source ends before.
  bool ensure(std::size_t num_bytes);

  /// Reads once more; false at the end of the source.
  bool fill();

  void consume(std::size_t num_bytes) {
    begin_ += num_bytes;
    offset_ += num_bytes;
  }

  /// Where available() begins in the (unpacked) stream.
  [[nodiscard]] std::uint64_t offset() const { return offset_; }
  [[nodiscard]] const ByteSource& source() const { return *source_; }

 private:
  void make_room(std::size_t num_bytes);

  std::unique_ptr<ByteSource> source_;
  std::vector<char> bytes_;
  std::size_t num_read_bytes_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::uint64_t offset_ = 0;
};

}  // namespace setsquare
