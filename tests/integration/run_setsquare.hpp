// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Runs the `setsquare` command as a user does.
#pragma once

#include <filesystem>
#include <string>

namespace setsquare::testing {

/// What a command left behind.
struct CommandOutcome {
  int exit_code = -1;  ///< -1 where it was ended by a signal.
  std::string out;
  std::string err;
};

/// Runs `setsquare ARGUMENTS` through the shell: redirections and pipes may stand in `arguments`.
[[nodiscard]] CommandOutcome run_setsquare(const std::string& arguments);

/// A folder for one test, empty at its beginning and removed at its end.
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
