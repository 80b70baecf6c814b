// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/outputs/output_directory.hpp"

#include <system_error>

#include "setsquare/core/error.hpp"

namespace setsquare::app {
namespace {

/// The directory and those above it that are not there yet, the innermost first.
std::vector<std::filesystem::path> absent_directories(const std::filesystem::path& path) {
  std::vector<std::filesystem::path> absent;
  std::error_code ignored;
  for (auto outer = path; !outer.empty() && !std::filesystem::exists(outer, ignored);
       outer = outer.parent_path()) {
    if (outer.has_filename()) absent.push_back(outer);
  }
  return absent;
}

}  // namespace

OutputDirectory::OutputDirectory(const std::string& path) : path_(path) {
  std::error_code error;
  made_ = absent_directories(path_);
  std::filesystem::create_directories(path_, error);
  if (error) throw FileError(path, "cannot be made: " + error.message());
  if (!std::filesystem::is_directory(path_)) throw FileError(path, "is not a directory");
}

OutputDirectory::~OutputDirectory() {
  std::error_code error;
  for (const auto& made : made_) {
    if (!std::filesystem::is_empty(made, error) || error) return;
    std::filesystem::remove(made, error);
  }
}

}  // namespace setsquare::app
