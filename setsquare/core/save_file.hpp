// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace setsquare {

/// Writes the bytes to a temporary name beside `path` and renames it: a killed run leaves no half
/// file, and an older file stays whole until then. Throws FileError.
void save_file(const std::string& path, std::string_view bytes);

}  // namespace setsquare
