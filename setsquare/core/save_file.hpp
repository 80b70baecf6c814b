// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace setsquare {

/// Writes the bytes to a new temporary name in the folder of `path` and renames it: a killed run
/// leaves no half file under the name, and an older file stays whole until then; its permissions
/// are kept. A symbolic link stays, and the file that it names is replaced. Anything but a regular
/// file (a device, a pipe, /dev/stdout) is written to directly. Throws FileError.
void save_file(const std::string& path, std::string_view bytes);

/// A file to write: path and bytes (not owned).
struct FileBytes {
  std::string path;
  std::string_view bytes;
};

/// save_file for files that belong together: all are written under temporary names before the first
/// is renamed, in the order given, so that they change together as far as renames can.
void save_files(std::span<const FileBytes> files);

/// The same, file after file: none of them need be in memory when the next one is made.
class StagedFiles {
 public:
  StagedFiles();
  /// Removes what was not committed.
  ~StagedFiles();
  StagedFiles(const StagedFiles&) = delete;
  StagedFiles& operator=(const StagedFiles&) = delete;

  /// Written under a temporary name. Throws FileError.
  void add(const std::string& path, std::string_view bytes);

  /// The files take their names, in their order. Throws FileError.
  void commit();

 private:
  class Files;
  std::unique_ptr<Files> files_;
};

/// A file that grows piece by piece, for what does not fit into memory; like save_file's it comes
/// under its name as a whole or not at all. What is no regular file is written to directly.
class GrowingFile {
 public:
  /// Throws FileError where it cannot be made.
  explicit GrowingFile(const std::string& path);
  /// Removes what was not committed.
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  /// Throws FileError.
  void append(std::string_view bytes);

  /// The file takes its name. Throws FileError.
  void commit();

  class Target;  ///< Where the bytes go; of no use to others.

 private:
  std::unique_ptr<Target> target_;
};

}  // namespace setsquare
