// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/carmen/log.hpp"

#include <fmt/core.h>

#include <utility>

namespace setsquare {
CarmenLog::CarmenLog(std::unique_ptr<InputBuffer> input, const LogOptions& options)
    : LineLog(std::move(input)) {
  state_.options = options;
}

LineOutcome CarmenLog::read_line(std::string_view line, LogRecord& record) {
  return read_carmen_line(line, state_, record);
}

std::string CarmenLog::reason(std::string_view line) const {
  return fmt::format("{}: {}", shown_beginning(line.substr(0, line.find(' '))), state_.reason);
}

}  // namespace setsquare
