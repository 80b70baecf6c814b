// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from main.cpp: the errors for unknown words, and the help.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace setsquare::app {

/// Bad file, option or parameter.
inline constexpr int kExitBadInput = 2;
/// With --strict: the result is there, and in doubt. A subcommand throws CLI::RuntimeError of it.
inline constexpr int kExitDoubtful = 3;

/// Gives the application, and all subcommands that are added to it later, the form of help that
/// this command has: the default of each option after its description.
void set_help_form(CLI::App& application);

/// Parses the command line, which runs the subcommand; returns the exit code. What is wrong with
/// it goes to standard error as one line; no command at all is answered by a list of the commands.
/// What a subcommand throws passes through.
[[nodiscard]] int parse_and_run(CLI::App& application, int argc, char** argv);

/// Prints one line on standard error; returns kExitBadInput.
int complain(const std::string& message);

}  // namespace setsquare::app
