// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A recorder that is told to be careful (rosbag2's preset "resilient") writes each page of its
// database into a second file first, "x.db3-wal", and moves the pages over now and then. Where it
// was killed, the newest messages are in that file only, and SQLite would have to write to get at
// them. Format: https://www.sqlite.org/fileformat2.html, section 4.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "setsquare/io/bytes/seekable_file.hpp"

namespace setsquare::sqlite {

/// The pages that a write-ahead log holds, as far as its transactions are whole.
class WriteAheadLog {
 public:
  /// Reads through the log once. What is damaged, and all that follows, is left out, as SQLite does
  /// it. Throws FileError.
  explicit WriteAheadLog(SeekableFile file);

  /// Bytes per page; 0 where the log holds no whole transaction.
  [[nodiscard]] std::uint32_t page_bytes() const { return num_pages_ > 0 ? page_bytes_ : 0; }

  /// Pages of the database after the last transaction.
  [[nodiscard]] std::uint32_t num_pages() const { return num_pages_; }

  /// Where the newest state of a page (numbered from 1) begins in the log's file, if it is there.
  [[nodiscard]] std::optional<std::uint64_t> offset_of(std::uint32_t page) const;

  [[nodiscard]] const SeekableFile& file() const { return file_; }
  [[nodiscard]] std::size_t num_newer_pages() const { return offset_of_page_.size(); }

 private:
  /// Where each page begins that a transaction wrote.
  using Transaction = std::unordered_map<std::uint32_t, std::uint64_t>;

  void commit(Transaction& transaction, std::uint32_t num_pages);

  SeekableFile file_;
  std::uint32_t page_bytes_ = 0;
  std::uint32_t num_pages_ = 0;
  Transaction offset_of_page_;
};

}  // namespace setsquare::sqlite
