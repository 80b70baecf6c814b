// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/chunked_input.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace setsquare {

ByteWindow& ChunkedInput::next_record() {
  if (chunk_ && chunk_->available().empty()) chunk_.reset();
  if (chunk_) return *chunk_;
  return *file_;
}

std::uint64_t ChunkedInput::position() const { return chunk_ ? chunk_position_ : file_->offset(); }

std::string ChunkedInput::location(std::uint64_t offset) const {
  if (!chunk_) return fmt::format("offset {}", offset);
  return fmt::format("offset {}, byte {} of the unpacked chunk", chunk_position_, offset);
}

std::string ChunkedInput::location() const {
  return location(chunk_ ? chunk_->offset() : file_->offset());
}

std::string ChunkedInput::enter_chunk(Packing packing,
                                      std::uint64_t num_bytes_packed,
                                      std::optional<std::uint64_t> num_bytes_stated) {
  const auto num_wanted = static_cast<std::size_t>(num_bytes_packed);
  chunk_position_ = file_->offset();
  file_->ensure(num_wanted);
  const std::string_view packed = file_->available().substr(0, num_wanted);
  const BlockUnpacker::Block block = unpacker_.unpack(packing, packed, num_bytes_stated);
  chunk_.emplace(block.bytes);
  file_->consume(block.num_packed_bytes > 0 ? block.num_packed_bytes : packed.size());
  return block.damage;
}

}  // namespace setsquare
