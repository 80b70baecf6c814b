// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/byte_source.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bytes/gzip_source.hpp"

namespace setsquare {
namespace {

class FileSource final : public ByteSource {
 public:
  explicit FileSource(const std::string& path) : path_(path == "-" ? "standard input" : path) {
    file_ = path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file_ < 0) throw FileError(path_, std::strerror(errno));
    struct stat status {};
    if (::fstat(file_, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0) {
      size_ = static_cast<double>(status.st_size);
    }
  }
  FileSource(const FileSource&) = delete;
  FileSource& operator=(const FileSource&) = delete;
  ~FileSource() override {
    if (file_ != STDIN_FILENO) ::close(file_);
  }

  std::size_t read(std::span<char> bytes) override {
    ssize_t num_read = 0;
    do {
      num_read = ::read(file_, bytes.data(), bytes.size());
    } while (num_read < 0 && errno == EINTR);
    if (num_read < 0) throw FileError(path_, std::strerror(errno));
    num_read_ += static_cast<double>(num_read);
    return static_cast<std::size_t>(num_read);
  }

  std::optional<double> fraction_read() const override {
    if (size_ == 0.0) return std::nullopt;
    return std::min(1.0, num_read_ / size_);
  }

 private:
  std::string path_;
  int file_ = -1;
  double size_ = 0.0;
  double num_read_ = 0.0;
};

class MemorySource final : public ByteSource {
 public:
  explicit MemorySource(std::string bytes) : bytes_(std::move(bytes)) {}

  std::size_t read(std::span<char> bytes) override {
    const std::size_t num_bytes = std::min(bytes.size(), bytes_.size() - position_);
    std::copy_n(bytes_.data() + position_, num_bytes, bytes.data());
    position_ += num_bytes;
    return num_bytes;
  }

 private:
  std::string bytes_;
  std::size_t position_ = 0;
};

/// The bytes already taken from a source for a look, then the rest of it.
class PrefixedSource final : public ByteSource {
 public:
  PrefixedSource(std::string prefix, std::unique_ptr<ByteSource> rest)
      : prefix_(std::move(prefix)), rest_(std::move(rest)) {}

  std::size_t read(std::span<char> bytes) override {
    const std::size_t num_bytes = prefix_.read(bytes);
    return num_bytes > 0 ? num_bytes : rest_->read(bytes);
  }
  std::optional<double> fraction_read() const override { return rest_->fraction_read(); }
  std::string damage() const override { return rest_->damage(); }

 private:
  MemorySource prefix_;
  std::unique_ptr<ByteSource> rest_;
};

}  // namespace

std::unique_ptr<ByteSource> open_file_source(const std::string& path) {
  return std::make_unique<FileSource>(path);
}

std::unique_ptr<ByteSource> make_memory_source(std::string bytes) {
  return std::make_unique<MemorySource>(std::move(bytes));
}

std::unique_ptr<ByteSource> unpack(std::unique_ptr<ByteSource> source) {
  std::string magic(2, '\0');
  std::size_t num_read = 0;
  while (num_read < magic.size()) {
    const std::size_t more = source->read(std::span(magic).subspan(num_read));
    if (more == 0) break;
    num_read += more;
  }
  magic.resize(num_read);
  auto whole = std::make_unique<PrefixedSource>(magic, std::move(source));
  if (magic != "\x1f\x8b") return whole;
  return std::make_unique<GzipSource>(std::move(whole));
}

}  // namespace setsquare
