// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "setsquare/io/logs/log_reader.hpp"

namespace setsquare {

/// Appends a record of any kind as one line that JsonLinesLog reads back exactly (docs/formats.md):
/// every number has the fewest digits that read back to it, NaN is null, infinities are "inf" and
/// "-inf". Throws ParameterError where a scan is not valid or has no beam, or a record of another
/// kind lacks its pose.
void append_json_record(std::string& log, const LogRecord& record);

}  // namespace setsquare
