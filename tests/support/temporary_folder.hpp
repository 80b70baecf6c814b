// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace setsquare::testing {

/// A folder for one test, empty at its beginning and removed at its end. Each has a name of its
/// own: CTest runs tests side by side.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Writes a file into the folder and returns its path, quoted for the shell.
  std::string write(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path path_;
};

/// The text of a file, empty where there is none.
[[nodiscard]] std::string content_of(const std::filesystem::path& path);

}  // namespace setsquare::testing
