// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace setsquare {

/// Names of the files in a folder that are a number with the extension ".tum", as 1.tum is, sorted.
/// Other files there are not ours. None where there is no such folder.
[[nodiscard]] std::vector<std::string> numbered_tum_files(const std::filesystem::path& folder);

}  // namespace setsquare
