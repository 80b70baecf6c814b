// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace setsquare {

/// Bytes in order, from a file, a pipe, memory or a decompressor.
class ByteSource {
 public:
  virtual ~ByteSource() = default;

  /// Reads up to bytes.size() bytes and returns how many; 0 only at the end. Throws FileError.
  [[nodiscard]] virtual std::size_t read(std::span<char> bytes) = 0;

  /// How much has been read, 0 to 1, where the size is known.
  [[nodiscard]] virtual std::optional<double> fraction_read() const { return std::nullopt; }

  /// Why the bytes ended before their time (a gzip stream cut short or corrupt); empty if not.
  [[nodiscard]] virtual std::string damage() const { return {}; }
};

/// A file, or standard input for "-". Throws FileError where it cannot be opened.
[[nodiscard]] std::unique_ptr<ByteSource> open_file_source(const std::string& path);

/// Bytes in memory.
[[nodiscard]] std::unique_ptr<ByteSource> make_memory_source(std::string bytes);

/// Looks at the first bytes of `source`: unpacks it where they are gzip's magic, else hands on the
/// same bytes.
[[nodiscard]] std::unique_ptr<ByteSource> unpack(std::unique_ptr<ByteSource> source);

}  // namespace setsquare
