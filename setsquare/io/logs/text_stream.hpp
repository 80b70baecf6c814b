// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from open_log(), its only user: which text a log is, is a question of its own.
#pragma once

#include <memory>
#include <string>

#include "setsquare/io/bytes/input_buffer.hpp"
#include "setsquare/io/logs/record_stream.hpp"

namespace setsquare {

/// Takes `input` and reads it where its first bytes, which are in memory, show a log that is text:
/// CARMEN, JSON lines, a table of scans, or rows of angles and distances where the options say so.
/// Null, and `input` kept, where they show none of these. Throws FormatError where only the options
/// are missing, or the text is of another form than it must be.
[[nodiscard]] std::unique_ptr<RecordStream> open_text_stream(std::unique_ptr<InputBuffer>& input,
                                                             const std::string& name,
                                                             const LogOptions& options);

}  // namespace setsquare
