// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace setsquare {

/// What the command prints as one line before it exits with code 2: a file, option or parameter
/// that cannot be used.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that cannot be opened, read or written.
class FileError : public Error {
 public:
  /// The message is "PATH: REASON".
  FileError(const std::string& path, const std::string& reason);
};

/// A file whose content is not what its format demands. `location` is "line 12" or "offset 3456",
/// or empty where the whole file is meant.
class FormatError : public Error {
 public:
  /// The message is "PATH, LOCATION: REASON", or as FileError's where the location is empty.
  FormatError(const std::string& path, const std::string& location, const std::string& reason);
};

/// A parameter outside its domain; `name` is the field's name, unit suffix included.
class ParameterError : public Error {
 public:
  /// The message is "parameter NAME: REASON".
  ParameterError(const std::string& name, const std::string& reason);
};

}  // namespace setsquare
