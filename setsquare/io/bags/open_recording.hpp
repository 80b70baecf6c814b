// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "setsquare/io/bags/message_source.hpp"

namespace setsquare {

class InputBuffer;  // setsquare/io/bytes/input_buffer.hpp

/// Opens what only a path can name: a folder with the files of a recording, its metadata.yaml, or
/// an SQLite file. Null where the path is none of these. Throws FileError, FormatError.
[[nodiscard]] std::unique_ptr<MessageSource> open_recording_at(const std::string& path);

/// Opens a file of a ROS 2 bag: SQLite or MCAP. Throws FileError, FormatError.
[[nodiscard]] std::unique_ptr<MessageSource> open_recording_file(const std::string& path);

/// The recording whose bytes `input` holds: a ROS 1 bag, MCAP, or SQLite that came packed or
/// through a pipe. Null, and `input` untouched, where its beginning is that of none. `name` stands
/// in messages for the path. Throws FormatError.
[[nodiscard]] std::unique_ptr<MessageSource> recording_in(std::unique_ptr<InputBuffer>& input,
                                                          const std::string& name);

}  // namespace setsquare
