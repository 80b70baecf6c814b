// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/data_dir.hpp"

#include <cstdlib>

namespace setsquare::testing {

std::optional<std::filesystem::path> data_file(const std::string& name) {
  const char* folder = std::getenv("SETSQUARE_DATA_DIR");
  const std::filesystem::path root =
      folder != nullptr ? std::filesystem::path(folder)
                        : std::filesystem::path(SETSQUARE_SOURCE_DIR) / ".." / "shared" / "data";
  std::filesystem::path path = root / name;
  if (!std::filesystem::exists(path)) return std::nullopt;
  return path;
}

}  // namespace setsquare::testing
