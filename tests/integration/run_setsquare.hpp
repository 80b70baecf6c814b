// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Runs the `setsquare` command as a user does.
#pragma once

#include <string>

#include "tests/support/temporary_folder.hpp"

namespace setsquare::testing {

/// What a command left behind.
struct CommandOutcome {
  int exit_code = -1;  ///< -1 where it was ended by a signal.
  std::string out;
  std::string err;
};

/// Runs `setsquare ARGUMENTS` through the shell: redirections and pipes may stand in `arguments`.
[[nodiscard]] CommandOutcome run_setsquare(const std::string& arguments);

}  // namespace setsquare::testing
