// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/outputs/output_file.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <iostream>
#include <system_error>
#include <utility>

#include "apps/setsquare/outputs/ending_signals.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/core/save_file.hpp"

namespace setsquare::app {
namespace {

[[noreturn]] void complain_of_output(const std::string& path, const std::string& reason) {
  throw FileError(path, "cannot be written: " + reason);
}

/// A file is replaced, so its folder must be writable; a device or a pipe must itself be writable.
void require_writable(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (path.empty()) throw Error("-o: the name of the output is empty");
  if (fs::is_directory(path, error)) complain_of_output(path, "it is a directory");
  const bool is_replaced = !fs::exists(path, error) || fs::is_regular_file(path, error);
  const fs::path target = fs::weakly_canonical(path, error);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  const fs::path& changed = is_replaced ? folder : target;
  const int wanted = is_replaced ? W_OK | X_OK : W_OK;
  if (::access(changed.c_str(), wanted) == 0) return;
  complain_of_output(
      path,
      fmt::format(
          "{}: {}", changed.string(), std::error_code(errno, std::generic_category()).message()));
}

}  // namespace

OutputFile::OutputFile(std::string path, const InputPaths& inputs) : path_(std::move(path)) {
  if (path_ == "-") return;
  refuse_input(path_, inputs);
  require_writable(path_);
}

void OutputFile::write(std::string_view bytes) const {
  if (path_ == "-") {
    std::cout << bytes << std::flush;
    return;
  }
  EndingSignals signals([] {});
  const auto held = signals.hold();  // no half file under a temporary name
  save_file(path_, bytes);
}

}  // namespace setsquare::app
