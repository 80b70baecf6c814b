// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/save_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void complain(const std::string& path, const std::string& reason) {
  throw FileError(path, "cannot be written: " + reason);
}

/// The name at the end of a chain of symbolic links, whether there is a file of that name or not.
fs::path behind_links(fs::path path) {
  constexpr int kMaxLinks = 40;
  std::error_code error;
  for (int i = 0; i < kMaxLinks && fs::is_symlink(fs::symlink_status(path, error)); ++i) {
    const fs::path target = fs::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / target;
  }
  return path;
}

/// Whether the name stands for an open stream of the process, whatever that leads to.
bool is_open_stream(const std::string& path) {
  return path.starts_with("/dev/std") || path.starts_with("/dev/fd/") ||
         path.starts_with("/proc/self/fd/");
}

/// Creates a file that was not there, `path` with a number and ".part", which is left in
/// `temporary`. Null where that fails, with the reason in errno.
std::FILE* open_temporary(const fs::path& path, fs::path& temporary) {
  constexpr int kMaxLeftovers = 1000;
  for (int i = 0; i < kMaxLeftovers; ++i) {
    temporary = path;
    temporary += '.';
    temporary += std::to_string(i);
    temporary += ".part";
    std::FILE* const file = std::fopen(temporary.c_str(), "wbx");
    if (file != nullptr || errno != EEXIST) return file;
  }
  return nullptr;
}

/// Writes and closes; the reason of a failure, or 0.
int write_and_close(std::FILE* file, std::string_view bytes) {
  errno = 0;
  const bool is_written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  const int write_error = is_written ? 0 : (errno != 0 ? errno : EIO);
  const bool is_closed = std::fclose(file) == 0;
  if (write_error != 0 || is_closed) return write_error;
  return errno;
}

}  // namespace

void save_file(const std::string& path, std::string_view bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (is_open_stream(path) || (fs::exists(status) && !fs::is_regular_file(status))) {
    std::FILE* const file = std::fopen(path.c_str(), "ab");
    const int failure = file == nullptr ? errno : write_and_close(file, bytes);
    if (failure != 0) complain(path, std::strerror(failure));
    return;
  }
  const fs::path target = behind_links(path);
  fs::path temporary;
  std::FILE* const file = open_temporary(target, temporary);
  if (file == nullptr) complain(path, std::strerror(errno));
  error = std::error_code(write_and_close(file, bytes), std::generic_category());
  if (!error && fs::exists(status)) fs::permissions(temporary, status.permissions(), error);
  if (!error) fs::rename(temporary, target, error);
  if (!error) return;
  std::error_code ignored;
  fs::remove(temporary, ignored);
  complain(path, error.message());
}

}  // namespace setsquare
