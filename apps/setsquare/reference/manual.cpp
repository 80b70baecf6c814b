// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/reference/manual.hpp"

#include <fmt/core.h>

#include <sstream>

namespace setsquare::app {
namespace {

/// A text as roff takes it: dashes are minus signs, and a line begins with no dot or quote.
std::string escaped(const std::string& text) {
  std::string result;
  bool starts_line = true;
  for (const char c : text) {
    if (starts_line && (c == '.' || c == '\'')) result += "\\&";
    starts_line = c == '\n';
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
  }
  return result;
}

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }

std::string item(const CommandOption& option) {
  std::string names;
  for (const std::string& name : option.names) names += (names.empty() ? "" : ", ") + bold(name);
  const bool is_positional = !option.names.front().starts_with('-');
  if (option.takes_value() && !is_positional) names += " \\fI" + escaped(option.value) + "\\fR";
  std::string text = ".TP\n" + names + "\n" + escaped(option.description);
  if (!option.default_text.empty()) text += escaped(" (default: " + option.default_text + ")");
  return text + ".\n";
}

std::string items(const char* heading, const std::vector<CommandOption>& options) {
  if (options.empty()) return {};
  std::string text = fmt::format(".SH {}\n", heading);
  for (const CommandOption& option : options) text += item(option);
  return text;
}

std::string synopsis(const Command& command) {
  std::string text = ".SH SYNOPSIS\n" + bold(command.joined_path(" ")) + " [\\fIOPTIONS\\fR]";
  if (!command.subcommands.empty()) text += " \\fISUBCOMMAND\\fR";
  for (const CommandOption& positional : command.positionals) {
    text += " \\fI" + escaped(positional.names.front()) + "\\fR";
  }
  return text + "\n";
}

/// The footer of --help: lines as they stand, examples apart.
std::string footer(const std::string& text) {
  std::string result;
  std::istringstream lines(text);
  bool has_examples = false;
  for (std::string line; std::getline(lines, line);) {
    if (line == "Examples:" || line == "Example:") {
      result += ".SH EXAMPLES\n.nf\n";
      has_examples = true;
      continue;
    }
    if (result.empty()) result += ".SH NOTES\n";
    result += escaped(line) + "\n";
  }
  return has_examples ? result + ".fi\n" : result;
}

std::string below(const Command& command) {
  if (command.subcommands.empty()) return {};
  std::string text = ".SH SUBCOMMANDS\n";
  for (const Command& subcommand : command.subcommands) {
    text += ".TP\n" + bold(subcommand.joined_path("-")) + "(1)\n" +
            escaped(subcommand.description) + ".\n";
  }
  return text;
}

constexpr auto kExitStatus =
    ".SH EXIT STATUS\n0 where all went well, 2 for a file, option or parameter that cannot be "
    "used, 3 where \\fB\\-\\-strict\\fR was asked for and the map is doubtful.\n";

}  // namespace

std::string manual_page(const Command& command) {
  const std::string name = command.joined_path("-");
  return fmt::format(".TH {} 1 \"\" \"setsquare {}\" \"Setsquare\"\n.SH NAME\n{} \\- {}\n",
                     escaped(name),
                     SETSQUARE_VERSION,
                     escaped(name),
                     escaped(command.description)) +
         synopsis(command) + items("ARGUMENTS", command.positionals) +
         items("OPTIONS", command.options) + below(command) + footer(command.footer) + kExitStatus;
}

std::string manual_file_name(const Command& command) { return command.joined_path("-") + ".1"; }

}  // namespace setsquare::app
