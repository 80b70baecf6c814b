// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/save_file.hpp"

#include <fmt/core.h>

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

/// Writes; the reason of a failure, or 0.
int write_to(std::FILE* file, std::string_view bytes) {
  errno = 0;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size()) return 0;
  return errno != 0 ? errno : EIO;
}

}  // namespace

/// A file under a temporary name in the folder of its path; removed unless it was renamed.
class StagedFile {
 public:
  explicit StagedFile(const std::string& path) : path_(path), target_(behind_links(path)) {
    file_ = open_temporary(target_, temporary_);
    if (file_ == nullptr) complain(path, std::strerror(errno));
  }
  StagedFile(StagedFile&& other) noexcept
      : path_(std::move(other.path_)),
        target_(std::move(other.target_)),
        temporary_(std::exchange(other.temporary_, {})),
        file_(std::exchange(other.file_, nullptr)) {}
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;
  StagedFile& operator=(StagedFile&&) = delete;
  ~StagedFile() {
    if (file_ != nullptr) std::fclose(file_);
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove(temporary_, ignored);
  }

  void append(std::string_view bytes) {
    if (const int failure = write_to(file_, bytes); failure != 0) {
      complain(path_, std::strerror(failure));
    }
  }

  /// Its bytes are on their way to the disk, and it has the permissions of the file that it
  /// replaces.
  void close() {
    const bool is_closed = std::fclose(std::exchange(file_, nullptr)) == 0;
    if (!is_closed) complain(path_, std::strerror(errno));
    std::error_code error;
    const fs::file_status status = fs::status(target_, error);
    error.clear();
    if (fs::exists(status)) fs::permissions(temporary_, status.permissions(), error);
    if (error) complain(path_, error.message());
  }

  void put_in_place() {
    std::error_code error;
    fs::rename(temporary_, target_, error);
    if (error) complain(path_, error.message());
    temporary_.clear();
  }

 private:
  std::string path_;
  fs::path target_;
  fs::path temporary_;
  std::FILE* file_ = nullptr;
};

namespace {

/// A device, a pipe, an open stream: nothing that could be replaced.
bool is_no_file(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return is_open_stream(path) || (fs::exists(status) && !fs::is_regular_file(status));
}

/// What cannot be replaced is written to.
class OpenStream {
 public:
  explicit OpenStream(const std::string& path)
      : path_(path), file_(std::fopen(path.c_str(), "ab")) {
    if (file_ == nullptr) complain(path, std::strerror(errno));
  }
  OpenStream(const OpenStream&) = delete;
  OpenStream& operator=(const OpenStream&) = delete;
  ~OpenStream() {
    if (file_ != nullptr) std::fclose(file_);
  }

  void append(std::string_view bytes) {
    if (const int failure = write_to(file_, bytes); failure != 0) {
      complain(path_, std::strerror(failure));
    }
  }

  void close() {
    if (std::fclose(std::exchange(file_, nullptr)) != 0) complain(path_, std::strerror(errno));
  }

 private:
  std::string path_;
  std::FILE* file_;
};

}  // namespace

void save_file(const std::string& path, std::string_view bytes) {
  const FileBytes file{path, bytes};
  save_files({&file, 1});
}

void save_files(std::span<const FileBytes> files) {
  StagedFiles staged;
  for (const FileBytes& file : files) staged.add(file.path, file.bytes);
  staged.commit();
}

class StagedFiles::Files {
 public:
  std::vector<StagedFile> staged;
};

StagedFiles::StagedFiles() : files_(std::make_unique<Files>()) {}
StagedFiles::~StagedFiles() = default;

void StagedFiles::add(const std::string& path, std::string_view bytes) {
  if (is_no_file(path)) {
    OpenStream stream(path);
    stream.append(bytes);
    stream.close();
    return;
  }
  StagedFile file(path);
  file.append(bytes);
  file.close();
  files_->staged.push_back(std::move(file));
}

void StagedFiles::commit() {
  for (StagedFile& file : files_->staged) file.put_in_place();
  files_->staged.clear();
}

class GrowingFile::Target {
 public:
  virtual ~Target() = default;
  virtual void append(std::string_view bytes) = 0;
  virtual void commit() = 0;
};

namespace {

class GrowingStream final : public GrowingFile::Target {
 public:
  explicit GrowingStream(const std::string& path) : stream_(path) {}
  void append(std::string_view bytes) override { stream_.append(bytes); }
  void commit() override { stream_.close(); }

 private:
  OpenStream stream_;
};

class GrowingStagedFile final : public GrowingFile::Target {
 public:
  explicit GrowingStagedFile(const std::string& path) : file_(path) {}
  void append(std::string_view bytes) override { file_.append(bytes); }
  void commit() override {
    file_.close();
    file_.put_in_place();
  }

 private:
  StagedFile file_;
};

std::unique_ptr<GrowingFile::Target> make_target(const std::string& path) {
  if (is_no_file(path)) return std::make_unique<GrowingStream>(path);
  return std::make_unique<GrowingStagedFile>(path);
}

}  // namespace

GrowingFile::GrowingFile(const std::string& path) : target_(make_target(path)) {}
GrowingFile::~GrowingFile() = default;
void GrowingFile::append(std::string_view bytes) { target_->append(bytes); }
void GrowingFile::commit() { target_->commit(); }

}  // namespace setsquare
