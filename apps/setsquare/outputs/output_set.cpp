// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/outputs/output_set.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <system_error>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/core/numbered_files.hpp"
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

bool is_folder_name(const std::string& name) { return name.ends_with('/'); }

/// Whether it is a folder, and no link to one.
bool is_own_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(fs::symlink_status(path, ignored));
}

/// The folder's numbered files go, and the folder where nothing else is in it; so does what is no
/// folder.
void remove_numbered(const fs::path& folder) {
  std::error_code error;
  if (is_own_folder(folder)) {
    for (const std::string& name : numbered_tum_files(folder)) {
      fs::remove(folder / name, error);
      require(folder / name, error);
    }
    fs::remove(folder, error);
    return;
  }
  fs::remove(folder, error);
  require(folder, error);
}

/// File by file: a folder may hold files of others.
void move_numbered(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_directory(to, error);
  require(to, error);
  for (const std::string& name : numbered_tum_files(from)) move(from / name, to / name);
}

}  // namespace

OutputSet::OutputSet(const std::string& path,
                     std::vector<std::string> names,
                     const InputPaths& inputs)
    : path_(path), names_(std::move(names)), signals_([this] { discard(); }) {
  const auto held = signals_.hold();
  try {
    make_directory();
    lock();
    refuse(inputs);
    finish_commit();
    begin();
  } catch (...) {
    discard();
    throw;
  }
}

OutputSet::~OutputSet() {
  const auto held = signals_.hold();
  discard();
}

void OutputSet::make_directory() {
  std::error_code error;
  for (fs::path outer = path_; !outer.empty() && !fs::exists(outer, error);
       outer = outer.parent_path()) {
    if (outer.has_filename()) made_.push_back(outer);
  }
  fs::create_directories(path_, error);
  if (error) throw FileError(path_.string(), "cannot be made: " + error.message());
  if (!fs::is_directory(path_)) throw FileError(path_.string(), "is not a directory");
}

void OutputSet::lock() {
  lock_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  require(path_, std::error_code(lock_ < 0 ? errno : 0, std::generic_category()));
  // Released by the system when the process ends, however it does. Some file systems have no locks.
  if (::flock(lock_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  throw FileError(path_.string(), "cannot be written: another run writes there");
}

void OutputSet::refuse(const InputPaths& inputs) const {
  std::error_code ignored;
  for (const std::string& name : names_) {
    if (is_folder_name(name)) {
      const fs::path folder = path_ / name.substr(0, name.size() - 1);
      if (!is_own_folder(folder)) refuse_input(folder, inputs);
      for (const std::string& file : numbered_tum_files(folder)) {
        refuse_input(folder / file, inputs);
      }
      continue;
    }
    if (fs::is_directory(path_ / name, ignored)) {
      throw FileError((path_ / name).string(), "cannot be written: it is a directory");
    }
    refuse_input(path_ / name, inputs);
  }
  // What a killed run left behind is about to be moved or removed.
  for (const char* const aside : {kNew, kWhole, kMove}) {
    for (const auto& entry : fs::directory_iterator(path_ / aside, ignored)) {
      refuse_input(entry.path(), inputs);
    }
  }
}

void OutputSet::begin() {
  is_begun_ = true;
  std::error_code error;
  fs::remove_all(path_ / kNew, error);
  if (!error) fs::create_directory(path_ / kNew, error);
  require(path_, error);
}

void OutputSet::discard() noexcept {
  std::error_code error;
  if (is_begun_) fs::remove_all(path_ / kNew, error);
  if (lock_ >= 0) ::close(std::exchange(lock_, -1));
  for (const fs::path& made : made_) {
    if (!fs::is_empty(made, error) || error) return;
    fs::remove(made, error);
  }
}

bool OutputSet::is_named(const std::string& name) const {
  return std::ranges::any_of(names_, [&](const std::string& known) {
    return name == known || (is_folder_name(known) && name.starts_with(known));
  });
}

void OutputSet::add(const std::string& name, std::string_view bytes) {
  assert(is_named(name));
  const auto held = signals_.hold();
  const fs::path folder = (path_ / kNew / name).parent_path();
  std::error_code error;
  fs::create_directory(folder, error);
  require(folder, error);
  save_file((path_ / kNew / name).string(), bytes);
  added_.push_back(name);
}

void OutputSet::commit() {
  const auto held = signals_.hold();
  move(path_ / kNew, path_ / kWhole);
  finish_commit();
}

void OutputSet::require_ours(const std::filesystem::path& set) const {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(set, ignored)) {
    const std::string name = entry.path().filename().string();
    if (is_named(is_own_folder(entry.path()) ? name + '/' : name)) continue;
    throw FileError(set.string(),
                    "is what another command left when it was killed: run that one again first");
  }
}

void OutputSet::finish_commit() {
  std::error_code error;
  require_ours(path_ / kWhole);
  require_ours(path_ / kMove);
  if (is_there(path_ / kWhole)) {
    for (auto name = names_.rbegin(); name != names_.rend(); ++name) {
      if (is_folder_name(*name)) {
        remove_numbered(path_ / name->substr(0, name->size() - 1));
        continue;
      }
      fs::remove(path_ / *name, error);
      require(path_ / *name, error);
    }
    move(path_ / kWhole, path_ / kMove);
  }
  if (!is_there(path_ / kMove)) return;
  for (const std::string& name : names_) {
    if (!is_there(path_ / kMove / name)) continue;
    if (is_folder_name(name)) {
      move_numbered(path_ / kMove / name, path_ / name);
    } else {
      move(path_ / kMove / name, path_ / name);
    }
  }
  fs::remove_all(path_ / kMove, error);
  require(path_ / kMove, error);
}

}  // namespace setsquare::app
