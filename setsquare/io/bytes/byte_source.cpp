// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/byte_source.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bytes/decompressor.hpp"
#include "setsquare/io/bytes/unpacking_source.hpp"

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

  /// Jumps where the file can; not beyond its end, which a seek would not notice.
  std::uint64_t skip(std::uint64_t num_bytes) override {
    struct stat status {};
    const off_t here = size_ > 0.0 ? ::lseek(file_, 0, SEEK_CUR) : -1;
    if (here < 0 || ::fstat(file_, &status) != 0) return ByteSource::skip(num_bytes);
    const off_t num_left = std::max(off_t{0}, status.st_size - here);
    const std::uint64_t num_skipped = std::min(num_bytes, static_cast<std::uint64_t>(num_left));
    if (::lseek(file_, static_cast<off_t>(num_skipped), SEEK_CUR) < 0) {
      throw FileError(path_, std::strerror(errno));
    }
    num_read_ += static_cast<double>(num_skipped);
    return num_skipped;
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

  std::uint64_t skip(std::uint64_t num_bytes) override {
    const std::uint64_t num_left = bytes_.size() - position_;
    const std::uint64_t num_skipped = std::min(num_bytes, num_left);
    position_ += static_cast<std::size_t>(num_skipped);
    return num_skipped;
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
  std::uint64_t skip(std::uint64_t num_bytes) override {
    const std::uint64_t num_skipped = prefix_.skip(num_bytes);
    return num_skipped + rest_->skip(num_bytes - num_skipped);
  }
  std::optional<double> fraction_read() const override { return rest_->fraction_read(); }
  std::string damage() const override { return rest_->damage(); }

 private:
  MemorySource prefix_;
  std::unique_ptr<ByteSource> rest_;
};

}  // namespace

std::uint64_t ByteSource::skip(std::uint64_t num_bytes) {
  std::array<char, 1 << 14> dropped;
  std::uint64_t num_skipped = 0;
  while (num_skipped < num_bytes) {
    const std::uint64_t num_wanted =
        std::min(num_bytes - num_skipped, std::uint64_t{dropped.size()});
    const std::size_t num_read =
        read(std::span(dropped).first(static_cast<std::size_t>(num_wanted)));
    if (num_read == 0) break;
    num_skipped += num_read;
  }
  return num_skipped;
}

std::unique_ptr<ByteSource> open_file_source(const std::string& path) {
  return std::make_unique<FileSource>(path);
}

std::unique_ptr<ByteSource> open_regular_file_source(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) throw FileError(path, std::strerror(errno));
  if (!S_ISREG(status.st_mode)) throw FileError(path, "not a regular file");
  return open_file_source(path);
}

std::unique_ptr<ByteSource> make_memory_source(std::string bytes) {
  return std::make_unique<MemorySource>(std::move(bytes));
}

std::unique_ptr<ByteSource> unpack(std::unique_ptr<ByteSource> source) {
  std::string magic(kMagicBytes, '\0');
  std::size_t num_read = 0;
  while (num_read < magic.size()) {
    const std::size_t more = source->read(std::span(magic).subspan(num_read));
    if (more == 0) break;
    num_read += more;
  }
  magic.resize(num_read);
  const std::optional<Packing> packing = packing_at(magic);
  auto whole = std::make_unique<PrefixedSource>(std::move(magic), std::move(source));
  if (!packing) return whole;
  return std::make_unique<UnpackingSource>(std::move(whole), *packing);
}

}  // namespace setsquare
