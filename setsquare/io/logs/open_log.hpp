// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "setsquare/io/logs/log_reader.hpp"

namespace setsquare {

class ByteSource;  // setsquare/io/bytes/byte_source.hpp

/// Opens a log: a file, plain or packed, the folder of a ROS 2 bag, or "-" for standard input. The
/// format is recognised by content.
/// Throws FileError (no such file, a directory, not permitted), FormatError (empty, or no log that
/// we know), ParameterError (options).
[[nodiscard]] std::unique_ptr<LogReader> open_log(const std::string& path,
                                                  const LogOptions& options = {});

/// The same from bytes that come from elsewhere; `name` stands in messages for the path.
[[nodiscard]] std::unique_ptr<LogReader> open_log(std::unique_ptr<ByteSource> source,
                                                  const std::string& name,
                                                  const LogOptions& options = {});

}  // namespace setsquare
