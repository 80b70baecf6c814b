// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "setsquare/io/bytes/byte_source.hpp"

namespace setsquare {

/// A regular file that is read at any place, in any order. Nothing is ever written to it or beside
/// it.
class SeekableFile {
 public:
  /// Throws FileError where the file cannot be opened, or is none that can be read so (a folder, a
  /// pipe).
  explicit SeekableFile(const std::string& path);

  /// The bytes of a source that can be read forwards only (standard input, a packed file), to its
  /// end, copied into a temporary file. That file lies in the folder for such files (TMPDIR, else
  /// /tmp), has no name there, and is gone with this object, however the program ends. Throws
  /// FileError where the bytes cannot be read or the folder has no room for them; `name` stands in
  /// messages for the source.
  SeekableFile(ByteSource& source, const std::string& name);

  SeekableFile(SeekableFile&& other) noexcept;
  SeekableFile& operator=(SeekableFile&&) = delete;
  ~SeekableFile();

  /// Reads from `offset` on, and returns how many bytes: fewer than asked for only at the end of
  /// the file. Throws FileError.
  [[nodiscard]] std::size_t read_at(std::uint64_t offset, std::span<char> bytes) const;

  /// Size in bytes when the file was opened.
  [[nodiscard]] std::uint64_t size() const { return size_; }

  /// The path, or what stands for it in messages.
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  SeekableFile(std::string name, int file) : name_(std::move(name)), file_(file) {}

  std::string name_;
  int file_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace setsquare
