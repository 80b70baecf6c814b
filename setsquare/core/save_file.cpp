// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/save_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

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
    temporary += fmt::format(".{}.part", i);
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

/// The bytes of a file under a temporary name in its folder; removed unless it was renamed.
class StagedFile {
 public:
  StagedFile(const std::string& path, std::string_view bytes)
      : path_(path), target_(behind_links(path)) {
    std::FILE* const file = open_temporary(target_, temporary_);
    if (file == nullptr) complain(path, std::strerror(errno));
    std::error_code error(write_and_close(file, bytes), std::generic_category());
    std::error_code absent;
    const fs::file_status status = fs::status(target_, absent);
    if (!error && fs::exists(status)) fs::permissions(temporary_, status.permissions(), error);
    if (!error) return;
    remove();
    complain(path, error.message());
  }
  StagedFile(StagedFile&& other) noexcept
      : path_(std::move(other.path_)),
        target_(std::move(other.target_)),
        temporary_(std::exchange(other.temporary_, {})) {}
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;
  StagedFile& operator=(StagedFile&&) = delete;
  ~StagedFile() { remove(); }

  void put_in_place() {
    std::error_code error;
    fs::rename(temporary_, target_, error);
    if (error) complain(path_, error.message());
    temporary_.clear();
  }

 private:
  void remove() {
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove(temporary_, ignored);
  }

  std::string path_;
  fs::path target_;
  fs::path temporary_;
};

/// A device, a pipe, an open stream: nothing that could be replaced.
bool is_no_file(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return is_open_stream(path) || (fs::exists(status) && !fs::is_regular_file(status));
}

void append_to(const std::string& path, std::string_view bytes) {
  std::FILE* const file = std::fopen(path.c_str(), "ab");
  const int failure = file == nullptr ? errno : write_and_close(file, bytes);
  if (failure != 0) complain(path, std::strerror(failure));
}

}  // namespace

void save_file(const std::string& path, std::string_view bytes) {
  const FileBytes file{path, bytes};
  save_files({&file, 1});
}

void save_files(std::span<const FileBytes> files) {
  std::vector<StagedFile> staged;
  staged.reserve(files.size());
  for (const FileBytes& file : files) {
    if (is_no_file(file.path)) {
      append_to(file.path, file.bytes);
    } else {
      staged.emplace_back(file.path, file.bytes);
    }
  }
  for (StagedFile& file : staged) file.put_in_place();
}

}  // namespace setsquare
