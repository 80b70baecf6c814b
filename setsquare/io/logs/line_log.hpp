// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "setsquare/io/bytes/line_reader.hpp"
#include "setsquare/io/logs/record_stream.hpp"

namespace setsquare {

/// What one line of a log turned out to be.
enum class LineOutcome {
  kRecord,    ///< It completed a record, which is filled.
  kNoRecord,  ///< A comment, an empty line, or one that holds no record that is wanted.
  kDamaged,   ///< Skipped.
};

/// The first characters of a text for a message, others than printable ASCII as '?'.
[[nodiscard]] std::string shown_beginning(std::string_view text);

/// The records of a log that is text, line by line: what all such formats have in common. Damaged
/// lines are counted by their number; of one that has no line end it is said that the file ends in
/// it.
class LineLog : public RecordStream {
 public:
  explicit LineLog(std::unique_ptr<InputBuffer> input);

  bool read(LogRecord& record) final;
  std::optional<double> fraction_read() const final { return input_->source().fraction_read(); }
  std::string damage() const final { return input_->source().damage(); }

 protected:
  /// Reads one line of at most LineReader::kMaxLineBytes, without its end.
  [[nodiscard]] virtual LineOutcome read_line(std::string_view line, LogRecord& record) = 0;

  /// Why the line that was read last is damaged.
  [[nodiscard]] virtual std::string reason(std::string_view line) const = 0;

  /// A record that the end of the text completes; false where there is none.
  [[nodiscard]] virtual bool read_end(LogRecord&) { return false; }

  /// The text's beginning, before any line is read: its first line is whole.
  [[nodiscard]] std::string_view look_ahead();

  [[nodiscard]] const LineReader& lines() const { return lines_; }

 private:
  std::unique_ptr<InputBuffer> input_;
  LineReader lines_;
};

}  // namespace setsquare
