// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "setsquare/io/bytes/byte_source.hpp"
#include "setsquare/io/bytes/byte_window.hpp"

namespace setsquare {

/// A window on a byte source: the unread bytes that are in memory, contiguous, however the source
/// delivers them. Memory is bounded by the largest size that ensure() is asked for, and grows only
/// as bytes arrive.
class InputBuffer final : public ByteWindow {
 public:
  explicit InputBuffer(std::unique_ptr<ByteSource> source);

  bool fill() override;
  std::uint64_t skip(std::uint64_t num_bytes) override;

  [[nodiscard]] const ByteSource& source() const { return *source_; }

 private:
  std::size_t make_room(std::size_t num_bytes);

  std::unique_ptr<ByteSource> source_;
  std::vector<char> bytes_;
  std::size_t num_read_bytes_;
};

}  // namespace setsquare
