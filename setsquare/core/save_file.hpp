// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace setsquare {

/// Writes the bytes to a new temporary name beside `path` and renames it: a killed run leaves no
/// half file under the name, and an older file stays whole until then; its permissions are kept. A
/// symbolic link stays, and the file that it names is replaced. What is no regular file (a device,
/// a pipe, /dev/stdout) is written to as it is. Throws FileError.
void save_file(const std::string& path, std::string_view bytes);

}  // namespace setsquare
