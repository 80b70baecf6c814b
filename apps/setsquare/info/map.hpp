// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>

namespace setsquare::app {

/// Whether a path names a map file, or a folder that `setsquare map` wrote. Reads its beginning.
[[nodiscard]] bool is_map(const std::string& path);

/// What is in a map: where it comes from, how much of what, whether it is to be believed. Throws
/// FileError, FormatError.
void print_map_info(const std::string& path, bool is_json, std::ostream& out);

}  // namespace setsquare::app
