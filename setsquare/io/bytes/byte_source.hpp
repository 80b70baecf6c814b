// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace setsquare {

/// Bytes in order, from a file, a pipe, memory or a decompressor.
class ByteSource {
 public:
  virtual ~ByteSource() = default;

  /// Reads up to bytes.size() bytes and returns how many; 0 only at the end. Throws FileError.
  [[nodiscard]] virtual std::size_t read(std::span<char> bytes) = 0;

  /// Passes over up to num_bytes bytes and returns how many: fewer only at the end. Throws
  /// FileError. Here they are read and dropped; sources that know better jump.
  virtual std::uint64_t skip(std::uint64_t num_bytes);

  /// How much has been read or skipped, 0 to 1, where the size is known.
  [[nodiscard]] virtual std::optional<double> fraction_read() const { return std::nullopt; }

  /// Why the bytes ended before their time (a packed stream cut short or corrupt); empty if not.
  [[nodiscard]] virtual std::string damage() const { return {}; }
};

/// A file, or standard input for "-". Throws FileError where it cannot be opened.
[[nodiscard]] std::unique_ptr<ByteSource> open_file_source(const std::string& path);

/// A file that is one: throws FileError for a pipe, a device or a folder, without waiting for what
/// might come out of it.
[[nodiscard]] std::unique_ptr<ByteSource> open_regular_file_source(const std::string& path);

/// Bytes in memory.
[[nodiscard]] std::unique_ptr<ByteSource> make_memory_source(std::string bytes);

/// Looks at the first bytes of `source`: unpacks it where they are the magic of gzip, bzip2, lz4 or
/// zstd, else hands on the same bytes.
[[nodiscard]] std::unique_ptr<ByteSource> unpack(std::unique_ptr<ByteSource> source);

}  // namespace setsquare
