// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setsquare/io/bytes/decompressor.hpp"

namespace setsquare {

/// Unpacks blocks of bytes that are in memory, one after another: the chunks of bags, packed
/// messages. Memory and decompressors are used again from block to block.
class BlockUnpacker {
 public:
  /// What unpacks to more than this is cut there, unless the constructor is told another limit.
  static constexpr std::size_t kMaxBlockBytes = std::size_t{1} << 30;

  explicit BlockUnpacker(std::size_t max_block_bytes = kMaxBlockBytes)
      : max_block_bytes_(max_block_bytes) {}

  struct Block {
    std::string_view bytes;  ///< Unpacked, as far as it went; valid until the next unpack().
    std::size_t num_packed_bytes = 0;  ///< What the whole frames at the front of `packed` took.
    std::string damage;                ///< What is wrong, as the end of a sentence; empty if not.
  };

  /// Unpacks `packed`: one frame or several. What stands before damage is given all the same. The
  /// size that the file states is not believed, and memory grows only as bytes arrive; where the
  /// size is wrong the bytes are given, and `damage` says so.
  [[nodiscard]] Block unpack(Packing packing,
                             std::string_view packed,
                             std::optional<std::uint64_t> num_bytes_stated = std::nullopt);

 private:
  struct Pace;

  [[nodiscard]] Decompressor& decompressor(Packing packing);
  void make_room(std::size_t num_bytes_packed, std::optional<std::uint64_t> num_bytes_stated);
  [[nodiscard]] Block unpack_frames(Packing packing, std::string_view packed, const Pace& pace);

  std::array<std::unique_ptr<Decompressor>, kPackings.size()> decompressors_;
  std::vector<char> bytes_;
  std::size_t max_block_bytes_;
};

}  // namespace setsquare
