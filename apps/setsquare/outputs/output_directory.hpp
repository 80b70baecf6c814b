// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace setsquare::app {

/// The directory of the results, made before the work begins, so that a wrong name is told at once.
/// Where the work fails, the directories that it made and left empty go again.
class OutputDirectory {
 public:
  /// Throws FileError.
  explicit OutputDirectory(const std::string& path);
  ~OutputDirectory();
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

  [[nodiscard]] std::string file(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;
};

}  // namespace setsquare::app
