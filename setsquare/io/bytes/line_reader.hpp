// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "setsquare/io/bytes/input_buffer.hpp"

namespace setsquare {

/// The lines of a text, one at a time, without copying them.
class LineReader {
 public:
  /// A line longer than this cannot be a record: it is cut there and marked.
  static constexpr std::size_t kMaxLineBytes = 1 << 21;

  explicit LineReader(InputBuffer& input) : input_(input) {}

  /// The next line without its end (LF or CR LF), nothing at the end of the text. Valid until the
  /// next call.
  [[nodiscard]] std::optional<std::string_view> next();

  /// Number of the line that next() returned last, from 1.
  [[nodiscard]] std::uint64_t line_number() const { return line_number_; }

  /// Whether that line had an end; the last one of a text may lack it.
  [[nodiscard]] bool has_end() const { return has_end_; }

  /// Whether that line was longer than kMaxLineBytes (what next() returned is its beginning).
  [[nodiscard]] bool is_too_long() const { return is_too_long_; }

 private:
  void skip_rest_of_line();

  InputBuffer& input_;
  std::size_t num_returned_bytes_ = 0;
  std::uint64_t line_number_ = 0;
  bool is_too_long_ = false;
  bool has_end_ = false;
};

}  // namespace setsquare
