// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/seekable_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

constexpr std::size_t kCopiedAtOnceBytes = 1 << 18;

int open_for_reading(const std::string& path) {
  // Without O_NONBLOCK a named pipe that nobody writes to would wait here.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) throw FileError(path, std::strerror(errno));
  return file;
}

[[noreturn]] void complain_of_copy(const std::string& name) {
  std::error_code error;
  const std::string folder = std::filesystem::temp_directory_path(error).string();
  throw FileError(
      name,
      fmt::format("cannot be copied into the folder of temporary files{}{}, as must be done with a "
                  "file that is packed or comes through a pipe: {}; set TMPDIR to a folder with "
                  "room, or unpack the file beforehand",
                  folder.empty() ? "" : " ",
                  folder,
                  std::strerror(errno)));
}

/// A file without a name: the system removes it when it is closed.
int open_nameless(const std::string& name_in_messages) {
  std::error_code error;
  std::string path = (std::filesystem::temp_directory_path(error) / "setsquare_XXXXXX").string();
  errno = error.value();
  const int file = error ? -1 : ::mkostemp(path.data(), O_CLOEXEC);
  if (file < 0) complain_of_copy(name_in_messages);
  ::unlink(path.c_str());
  return file;
}

/// Whether all bytes were written; errno says why not.
bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t num_written = ::write(file, bytes.data(), bytes.size());
    if (num_written < 0 && errno == EINTR) continue;
    if (num_written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(num_written));
  }
  return true;
}

}  // namespace

SeekableFile::SeekableFile(const std::string& path) : SeekableFile(path, open_for_reading(path)) {
  struct stat status {};
  if (::fstat(file_, &status) != 0) throw FileError(path, std::strerror(errno));
  if (S_ISDIR(status.st_mode)) throw FileError(path, std::strerror(EISDIR));
  if (!S_ISREG(status.st_mode)) throw FileError(path, "not a regular file");
  size_ = static_cast<std::uint64_t>(status.st_size);
}

SeekableFile::SeekableFile(ByteSource& source, const std::string& name)
    : SeekableFile(name, open_nameless(name)) {
  std::vector<char> block(kCopiedAtOnceBytes);
  while (const std::size_t num_read = source.read(block)) {
    if (!write_all(file_, {block.data(), num_read})) complain_of_copy(name);
    size_ += num_read;
  }
}

SeekableFile::SeekableFile(SeekableFile&& other) noexcept
    : name_(std::move(other.name_)), file_(std::exchange(other.file_, -1)), size_(other.size_) {}

SeekableFile::~SeekableFile() {
  if (file_ >= 0) ::close(file_);
}

std::size_t SeekableFile::read_at(std::uint64_t offset, std::span<char> bytes) const {
  std::size_t num_read = 0;
  while (num_read < bytes.size()) {
    const std::span<char> rest = bytes.subspan(num_read);
    const ssize_t more =
        ::pread(file_, rest.data(), rest.size(), static_cast<off_t>(offset + num_read));
    if (more < 0 && errno == EINTR) continue;
    if (more < 0) throw FileError(name_, std::strerror(errno));
    if (more == 0) break;
    num_read += static_cast<std::size_t>(more);
  }
  return num_read;
}

}  // namespace setsquare
