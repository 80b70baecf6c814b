// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "setsquare/io/bags/sqlite/write_ahead_log.hpp"
#include "setsquare/io/bytes/seekable_file.hpp"

namespace setsquare::sqlite {

/// Whether a file that begins so is an SQLite database.
[[nodiscard]] bool is_database(std::string_view beginning);

/// The bytes of a database as SQLite is to see them:
/// - whole pages only. SQLite takes zeros for what is missing of a page that was cut short, and
///   messages would end in zeros;
/// - as many pages as are there. SQLite refuses a file that is shorter than its header says;
/// - the newer pages of a write-ahead log in place of the file's.
class Pages {
 public:
  /// Throws FormatError where the file is no database, or too short for its first page; FileError.
  Pages(SeekableFile file, std::optional<SeekableFile> write_ahead_log);

  [[nodiscard]] std::uint64_t size_bytes() const { return std::uint64_t{num_pages_} * page_bytes_; }

  /// Reads within one page, or what the database begins with; returns how many bytes, fewer than
  /// asked for only at the end. Throws FileError.
  [[nodiscard]] std::size_t read_at(std::uint64_t offset, std::span<char> bytes) const;

  [[nodiscard]] const std::string& name() const { return file_.name(); }
  [[nodiscard]] std::uint32_t num_pages() const { return num_pages_; }

  /// Pages that the database should have; fewer are there where the file was cut short.
  [[nodiscard]] std::uint32_t num_pages_stated() const { return num_pages_stated_; }

  /// Pages that came from the write-ahead log.
  [[nodiscard]] std::size_t num_newer_pages() const { return log_ ? log_->num_newer_pages() : 0; }

 private:
  void measure();

  SeekableFile file_;
  std::optional<WriteAheadLog> log_;
  std::uint32_t page_bytes_ = 0;
  std::uint32_t num_pages_ = 0;
  std::uint32_t num_pages_stated_ = 0;
};

}  // namespace setsquare::sqlite
