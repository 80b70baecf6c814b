// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Programs of their own that the command starts: it neither compiles nor links them.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace setsquare::app {

/// A program beside the command.
struct OtherProgram {
  std::string name;          ///< "setsquare-experiment": in the command's folder, or in PATH's.
  std::string target;        ///< That builds it.
  std::string what_it_does;  ///< For --help where it is not there.
};

/// Adds a subcommand that becomes the program: all that follows goes to it as it is, --help
/// included, behind `first_arguments`. Running it throws FileError where the program is not there.
void add_other_program(CLI::App& application,
                       const std::string& subcommand,
                       const std::string& description,
                       const OtherProgram& program,
                       const std::vector<std::string>& first_arguments = {});

}  // namespace setsquare::app
