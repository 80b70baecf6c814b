// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/carmen/log.hpp"

#include <fmt/format.h>

#include <utility>

namespace setsquare {
namespace {

std::string reason_with_name(std::string_view reason, std::string_view line) {
  constexpr std::size_t kMaxShown = 20;
  std::string name;
  for (const char c : line.substr(0, std::min(line.find(' '), kMaxShown))) {
    name += c > ' ' && c <= '~' ? c : '?';
  }
  return fmt::format("{}: {}", name, reason);
}

}  // namespace

CarmenLog::CarmenLog(std::unique_ptr<InputBuffer> input, const LogOptions& options)
    : input_(std::move(input)), lines_(*input_) {
  state_.options = options;
}

bool CarmenLog::read(LogRecord& record) {
  while (const auto line = lines_.next()) {
    CarmenLine outcome = CarmenLine::kDamaged;
    if (lines_.is_too_long()) {
      state_.reason = "line too long";
    } else {
      outcome = read_carmen_line(*line, state_, record);
    }
    if (outcome == CarmenLine::kRecord) {
      record.position = lines_.line_number();
      return true;
    }
    if (outcome == CarmenLine::kDamaged) {
      problems().add(fmt::format("line {}", lines_.line_number()),
                     reason_with_name(state_.reason, *line));
    }
  }
  return false;
}

}  // namespace setsquare
