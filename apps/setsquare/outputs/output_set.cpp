// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/outputs/output_set.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <ranges>
#include <system_error>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/core/save_file.hpp"

namespace setsquare::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNew = ".setsquare-new";
constexpr const char* kWhole = ".setsquare-whole";
constexpr const char* kMove = ".setsquare-move";

void require(const fs::path& path, const std::error_code& error) {
  if (error) throw FileError(path.string(), "cannot be written: " + error.message());
}

void move(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  require(to, error);
}

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

}  // namespace

OutputSet::OutputSet(const std::string& path, std::vector<std::string> names)
    : directory_(path), path_(path), names_(std::move(names)) {
  lock();
  try {
    for (const std::string& name : names_) {
      std::error_code ignored;
      if (fs::is_directory(path_ / name, ignored)) {
        throw FileError((path_ / name).string(), "cannot be written: it is a directory");
      }
    }
    finish_commit();
    std::error_code error;
    fs::remove_all(path_ / kNew, error);
    if (!error) fs::create_directory(path_ / kNew, error);
    require(path_, error);
  } catch (...) {
    ::close(lock_);
    throw;
  }
}

OutputSet::~OutputSet() {
  std::error_code ignored;
  fs::remove_all(path_ / kNew, ignored);
  ::close(lock_);
}

void OutputSet::lock() {
  lock_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  require(path_, std::error_code(lock_ < 0 ? errno : 0, std::generic_category()));
  // Released by the system when the process ends, however it does. Some file systems have no locks.
  if (::flock(lock_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(lock_);
  throw FileError(path_.string(), "cannot be written: another run writes there");
}

void OutputSet::add(const std::string& name, std::string_view bytes) {
  assert(std::ranges::find(names_, name) != names_.end());
  save_file((path_ / kNew / name).string(), bytes);
  added_.push_back(name);
}

void OutputSet::commit() {
  move(path_ / kNew, path_ / kWhole);
  finish_commit();
}

void OutputSet::finish_commit() {
  std::error_code error;
  if (is_there(path_ / kWhole)) {
    for (const std::string& name : names_ | std::views::reverse) {
      fs::remove(path_ / name, error);
      require(path_ / name, error);
    }
    move(path_ / kWhole, path_ / kMove);
  }
  if (!is_there(path_ / kMove)) return;
  for (const std::string& name : names_) {
    if (is_there(path_ / kMove / name)) move(path_ / kMove / name, path_ / name);
  }
  fs::remove_all(path_ / kMove, error);
  require(path_ / kMove, error);
}

}  // namespace setsquare::app
