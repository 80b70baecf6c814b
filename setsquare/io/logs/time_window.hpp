// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "setsquare/io/logs/log_reader.hpp"

namespace setsquare {

/// A log as far as a window lets it through: records before `from_s` are left out, reading ends at
/// the first scan behind `to_s`, and of each laser not more scans than `max_rate_hz` are handed on.
/// `name` stands in messages for the path. Where no scan lies within the window, next() throws
/// FormatError at the end. Without limits the reader itself is returned.
[[nodiscard]] std::unique_ptr<LogReader> within(const LogWindow& window,
                                                std::unique_ptr<LogReader> reader,
                                                const std::string& name);

}  // namespace setsquare
