// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The options of the command as data: what completions and manual pages are made of.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace setsquare::app {

/// An option or a positional argument.
struct CommandOption {
  std::vector<std::string> names;    ///< With their dashes; the one name of a positional without.
  std::string value;                 ///< What it takes: "DIR", "default|paper"; empty for a flag.
  std::vector<std::string> choices;  ///< The values, where only these are taken.
  std::string description;
  std::string default_text;  ///< Empty where there is none to tell.

  [[nodiscard]] bool takes_value() const { return !value.empty(); }
};

/// A command or subcommand with all that --help knows.
struct Command {
  std::vector<std::string> path;  ///< {"setsquare", "evaluate", "ate"}.
  std::string description;
  std::string footer;
  std::vector<CommandOption> positionals;
  std::vector<CommandOption> options;
  std::vector<Command> subcommands;

  [[nodiscard]] const std::string& name() const { return path.back(); }
  /// The path with `separator` between: "setsquare evaluate ate".
  [[nodiscard]] std::string joined_path(const std::string& separator) const;
};

/// The whole tree below an application, in its order.
[[nodiscard]] Command command_tree(CLI::App& application);

/// A command and all below it, each before those below it.
[[nodiscard]] std::vector<const Command*> all_commands(const Command& root);

}  // namespace setsquare::app
