// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "setsquare/io/bags/message_source.hpp"
#include "setsquare/io/logs/log_reader.hpp"

namespace setsquare {

/// The records of messages that come while a robot drives: as a bag's (BagLog), but the first one
/// is handed on at once, so that the front laser is that of the first scan where
/// LogOptions::sensor names none. Throws ParameterError (options).
[[nodiscard]] std::unique_ptr<LogReader> open_live_log(std::unique_ptr<MessageSource> source,
                                                       const std::string& name,
                                                       const LogOptions& options);

}  // namespace setsquare
