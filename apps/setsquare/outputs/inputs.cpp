// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/outputs/inputs.hpp"

#include <fmt/core.h>

#include <system_error>

#include "setsquare/core/error.hpp"

namespace setsquare::app {

void refuse_input(const std::filesystem::path& target, const InputPaths& inputs) {
  std::error_code ignored;
  // A terminal or /dev/null may be read and written.
  if (!std::filesystem::is_regular_file(target, ignored)) return;
  for (const std::string& input : inputs) {
    const bool is_stream = input == "-";
    const std::filesystem::path path = is_stream ? "/dev/stdin" : input;
    if (!std::filesystem::equivalent(target, path, ignored)) continue;
    throw FileError(target.string(),
                    fmt::format("cannot be written: it is the file that is read ({})",
                                is_stream ? "standard input" : input));
  }
}

}  // namespace setsquare::app
