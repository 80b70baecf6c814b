// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/integration/run_setsquare.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>

namespace setsquare::testing {
namespace {

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

}  // namespace

CommandOutcome run_setsquare(const std::string& arguments) {
  const TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "out";
  const std::filesystem::path err = folder.path() / "err";
  const std::string command = "{ '" SETSQUARE_COMMAND "' " + arguments + "\n} >" + quoted(out) +
                              " 2>" + quoted(err) + " </dev/null";
  const int status = std::system(command.c_str());
  CommandOutcome outcome;
  if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
  outcome.out = content_of(out);
  outcome.err = content_of(err);
  return outcome;
}

}  // namespace setsquare::testing
