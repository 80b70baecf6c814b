// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/numbered_files.hpp"

#include <algorithm>
#include <string_view>
#include <system_error>

namespace setsquare {

std::vector<std::string> numbered_tum_files(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::filesystem::path name = entry.path().filename();
    const std::string stem = name.stem().string();
    const bool is_number = stem.find_first_not_of("0123456789") == std::string_view::npos;
    if (is_number && !stem.empty() && name.extension() == ".tum") names.push_back(name.string());
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace setsquare
