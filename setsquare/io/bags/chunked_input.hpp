// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The bytes of chunked recordings, apart from chunked_recording since it knows of no messages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "setsquare/io/bytes/block_unpacker.hpp"
#include "setsquare/io/bytes/input_buffer.hpp"

namespace setsquare {

/// A file of records, some of which are chunks: packed blocks of further records. It shows the
/// records one behind another, those of a chunk in the chunk's place.
class ChunkedInput {
 public:
  explicit ChunkedInput(std::unique_ptr<InputBuffer> file) : file_(std::move(file)) {}

  /// Where the next record begins: in the unpacked chunk while there is something left of it, else
  /// in the file.
  [[nodiscard]] ByteWindow& next_record();

  [[nodiscard]] bool is_in_chunk() const { return chunk_.has_value(); }

  /// Offset in the file of next_record(), or of the chunk around it.
  [[nodiscard]] std::uint64_t position() const;

  /// The same for people, of the record that begins at `offset` of what next_record() gave last. A
  /// chunk is named with the byte of its unpacked records.
  [[nodiscard]] std::string location(std::uint64_t offset) const;
  [[nodiscard]] std::string location() const;

  /// Unpacks the next num_bytes_packed bytes of the file, as many as there are, and goes on inside
  /// of them; behind them afterwards, or behind the packed frames where these end earlier. Returns
  /// what is wrong with them, as the end of a sentence.
  std::string enter_chunk(Packing packing,
                          std::uint64_t num_bytes_packed,
                          std::optional<std::uint64_t> num_bytes_stated);

  /// The records of the chunk just entered.
  [[nodiscard]] std::string_view chunk_bytes() const { return chunk_->available(); }

  /// Goes forward byte by byte, from the next one on, until is_record(window) says that a record
  /// begins there. False where none does before the end of the chunk or of the file.
  template <typename IsRecord>
  bool find_record(IsRecord is_record) {
    ByteWindow& bytes = next_record();
    while (bytes.skip(1) == 1) {
      if (is_record(bytes)) return true;
    }
    return false;
  }

  [[nodiscard]] const InputBuffer& file() const { return *file_; }

 private:
  std::unique_ptr<InputBuffer> file_;
  BlockUnpacker unpacker_;
  std::optional<ByteWindow> chunk_;
  std::uint64_t chunk_position_ = 0;
};

}  // namespace setsquare
