// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/reference/command_tree.hpp"

#include <fmt/core.h>

#include <CLI/Option.hpp>
#include <sstream>

#include "setsquare/core/joined.hpp"

namespace setsquare::app {
namespace {

std::vector<std::string> pieces_between_bars(const std::string& text) {
  std::vector<std::string> pieces;
  std::istringstream stream(text);
  for (std::string piece; std::getline(stream, piece, '|');) pieces.push_back(piece);
  return pieces;
}

CommandOption option_from(const CLI::Option& option) {
  CommandOption made;
  for (const std::string& name : option.get_snames()) made.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) made.names.push_back("--" + name);
  const bool is_positional = made.names.empty();
  if (is_positional) made.names.push_back(option.get_name(true));
  if (is_positional || option.get_expected_max() > 0) {
    const std::string type = option.get_type_name();
    made.value = type.empty() ? (is_positional ? made.names.front() : "VALUE") : type;
    if (type.find('|') != std::string::npos) made.choices = pieces_between_bars(type);
  }
  made.description = option.get_description();
  made.default_text = option.get_default_str();
  if (made.default_text == "[]") made.default_text.clear();  // An empty list.
  return made;
}

Command command_from(CLI::App& application, std::vector<std::string> path) {
  path.push_back(application.get_name());
  Command command;
  command.path = path;
  command.description = application.get_description();
  command.footer = application.get_footer();
  for (const CLI::Option* option : application.get_options()) {
    if (option->get_group().empty()) continue;  // Hidden.
    auto& list = option->get_positional() ? command.positionals : command.options;
    list.push_back(option_from(*option));
  }
  for (CLI::App* subcommand : application.get_subcommands({})) {
    command.subcommands.push_back(command_from(*subcommand, path));
  }
  return command;
}

void append(const Command& command, std::vector<const Command*>& all) {
  all.push_back(&command);
  for (const Command& subcommand : command.subcommands) append(subcommand, all);
}

}  // namespace

std::string Command::joined_path(const std::string& separator) const {
  return joined(path, separator);
}

Command command_tree(CLI::App& application) { return command_from(application, {}); }

std::vector<const Command*> all_commands(const Command& root) {
  std::vector<const Command*> all;
  append(root, all);
  return all;
}

}  // namespace setsquare::app
