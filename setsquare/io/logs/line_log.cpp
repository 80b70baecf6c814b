// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/line_log.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace setsquare {

std::string shown_beginning(std::string_view text) {
  constexpr std::size_t kMaxShown = 20;
  std::string shown(text.substr(0, kMaxShown));
  const auto is_printable = [](char c) { return c >= ' ' && c <= '~'; };
  std::ranges::replace_if(shown, std::not_fn(is_printable), '?');
  return shown;
}

LineLog::LineLog(std::unique_ptr<InputBuffer> input) : input_(std::move(input)), lines_(*input_) {}

std::string_view LineLog::look_ahead() {
  input_->ensure(LineReader::kMaxLineBytes);
  return input_->available();
}

bool LineLog::read(LogRecord& record) {
  while (const auto line = lines_.next()) {
    const bool is_too_long = lines_.is_too_long();
    const auto outcome = is_too_long ? LineOutcome::kDamaged : read_line(*line, record);
    if (outcome == LineOutcome::kRecord) {
      record.position = lines_.line_number();
      return true;
    }
    if (outcome == LineOutcome::kNoRecord) continue;
    const std::string why = is_too_long ? "line too long" : reason(*line);
    problems().add(fmt::format("line {}", lines_.line_number()),
                   lines_.has_end() ? why : why + "; the file ends in this line, cut off?");
  }
  return read_end(record);
}

}  // namespace setsquare
