// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace setsquare {

/// Bytes in memory, read from the front. This one holds bytes of somebody else, to their end; an
/// InputBuffer gets more from a source. So what reads records need not know where they are.
class ByteWindow {
 public:
  explicit ByteWindow(std::string_view bytes) : available_(bytes) {}
  ByteWindow(const ByteWindow&) = delete;
  ByteWindow& operator=(const ByteWindow&) = delete;
  virtual ~ByteWindow() = default;

  /// The unread bytes in memory. Valid until the next ensure(), fill() or skip().
  [[nodiscard]] std::string_view available() const { return available_; }

  /// Reads until at least num_bytes are available; false where the bytes end before.
  bool ensure(std::size_t num_bytes) {
    while (available_.size() < num_bytes) {
      if (!fill()) return false;
    }
    return true;
  }

  /// Reads once more; false at the end.
  virtual bool fill() { return false; }

  /// Goes on behind the next num_bytes bytes, which are available.
  void consume(std::size_t num_bytes) {
    available_.remove_prefix(num_bytes);
    offset_ += num_bytes;
  }

  /// Goes on behind the next num_bytes bytes, which need not be available and are not read where
  /// the source can jump. Returns how many there were: fewer only at the end.
  virtual std::uint64_t skip(std::uint64_t num_bytes) {
    const std::uint64_t num_skipped = std::min(num_bytes, std::uint64_t{available_.size()});
    consume(static_cast<std::size_t>(num_skipped));
    return num_skipped;
  }

  /// Where available() begins in all the (unpacked) bytes.
  [[nodiscard]] std::uint64_t offset() const { return offset_; }

 protected:
  void set_available(std::string_view bytes) { available_ = bytes; }
  void pass_over(std::uint64_t num_bytes) { offset_ += num_bytes; }

 private:
  std::string_view available_;
  std::uint64_t offset_ = 0;
};

}  // namespace setsquare
