// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/reference/completion.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "setsquare/core/joined.hpp"

namespace setsquare::app {
namespace {

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
  return text;
}

/// All names of a command's options, with spaces between.
std::string option_words(const Command& command) {
  std::vector<std::string> words;
  for (const CommandOption& option : command.options) {
    words.insert(words.end(), option.names.begin(), option.names.end());
  }
  return joined(words, " ");
}

/// What may stand where no option does: subcommands, or the choices of the first argument.
std::string argument_words(const Command& command) {
  std::vector<std::string> words;
  for (const Command& subcommand : command.subcommands) words.push_back(subcommand.name());
  if (words.empty() && !command.positionals.empty()) words = command.positionals.front().choices;
  return joined(words, " ");
}

/// The lines of bash's case: what may follow an option, and what may stand anywhere.
std::string bash_cases(const Command& command) {
  const std::string path = command.joined_path(" ");
  std::string cases;
  for (const CommandOption& option : command.options) {
    if (!option.takes_value()) continue;
    for (const std::string& name : option.names) {
      cases += option.choices.empty()
                   ? fmt::format("    \"{} {}\") return ;;\n", path, name)
                   : fmt::format(
                         "    \"{} {}\") COMPREPLY=($(compgen -W '{}' -- \"$word\")); "
                         "return ;;\n",
                         path,
                         name,
                         joined(option.choices, " "));
    }
  }
  return cases;
}

std::string in_single_quotes(const std::string& text) {
  return "'" + replaced(text, "'", "'\\''") + "'";
}

/// A description within zsh's brackets, where brackets and colons have a meaning.
std::string zsh_description(const std::string& text) {
  return replaced(replaced(replaced(text, "[", "("), "]", ")"), ":", "\\:");
}

std::string zsh_function(const Command& command) {
  std::string lines = fmt::format("_{}() {{\n", command.joined_path("_"));
  lines += "  local line state\n  _arguments -C";
  for (const CommandOption& option : command.options) {
    const std::string value = !option.takes_value() ? ""
                              : option.choices.empty()
                                  ? ":" + zsh_description(option.value) + ":_files"
                                  : fmt::format(":value:({})", joined(option.choices, " "));
    for (const std::string& name : option.names) {
      lines += " \\\n    " + in_single_quotes("*" + name + "[" +
                                              zsh_description(option.description) + "]" + value);
    }
  }
  if (command.subcommands.empty()) {
    const std::string words = argument_words(command);
    const std::string values = words.empty() ? "_files" : "(" + words + ")";
    return lines + " \\\n    '*:argument:" + values + "'\n}\n\n";
  }
  lines += " \\\n    '1:command:->command' '*::arguments:->arguments'\n  case $state in\n";
  lines += "    command) local -a commands=(";
  for (const Command& subcommand : command.subcommands) {
    lines += "\n      " + in_single_quotes(subcommand.name() + ":" + subcommand.description);
  }
  lines += ")\n      _describe command commands ;;\n    arguments)\n      case $line[1] in\n";
  for (const Command& subcommand : command.subcommands) {
    lines += fmt::format("        {}) _{} ;;\n", subcommand.name(), subcommand.joined_path("_"));
  }
  return lines + "      esac ;;\n  esac\n}\n\n";
}

/// When a line of fish's applies: after a command's name, and not after one below it.
std::string fish_condition(const Command& command) {
  if (command.path.size() == 1) return "__fish_use_subcommand";
  std::string condition = "__fish_seen_subcommand_from " + command.name();
  const std::string below = argument_words(command);
  if (!below.empty()) condition += "; and not __fish_seen_subcommand_from " + below;
  if (command.path.size() > 2) {
    condition += "; and __fish_seen_subcommand_from " + command.path[command.path.size() - 2];
  }
  return condition;
}

std::string fish_lines(const Command& command) {
  const std::string start =
      "complete -c setsquare -n " + in_single_quotes(fish_condition(command)) + " ";
  std::string lines;
  for (const Command& subcommand : command.subcommands) {
    lines += start + "-f -a " + subcommand.name() + " -d " +
             in_single_quotes(subcommand.description) + "\n";
  }
  if (command.subcommands.empty() && !argument_words(command).empty()) {
    lines += start + "-f -a " + in_single_quotes(argument_words(command)) + "\n";
  }
  for (const CommandOption& option : command.options) {
    std::string names;
    for (const std::string& name : option.names) {
      names += name.starts_with("--") ? "-l " + name.substr(2) + " " : "-s " + name.substr(1) + " ";
    }
    const std::string value = !option.takes_value() ? ""
                              : option.choices.empty()
                                  ? "-r "
                                  : fmt::format("-x -a '{}' ", joined(option.choices, " "));
    lines += start + names + value + "-d " + in_single_quotes(option.description) + "\n";
  }
  return lines;
}

}  // namespace

std::string bash_completion(const Command& root) {
  std::string paths;
  std::string after_options;
  std::string words;
  for (const Command* command : all_commands(root)) {
    const std::string path = command->joined_path(" ");
    if (command != &root) paths += fmt::format("      \"{}\") path=$longer ;;\n", path);
    after_options += bash_cases(*command);
    words += fmt::format("    \"{}\") options='{}' commands='{}' ;;\n",
                         path,
                         option_words(*command),
                         argument_words(*command));
  }
  return "# bash completion for setsquare\n"
         "_setsquare() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} last=${COMP_WORDS[COMP_CWORD - 1]}\n"
         "  local path=setsquare longer options commands i\n"
         "  COMPREPLY=()\n"
         "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
         "    longer=\"$path ${COMP_WORDS[i]}\"\n"
         "    case $longer in\n" +
         paths +
         "    esac\n"
         "  done\n"
         "  case \"$path $last\" in\n" +
         after_options +
         "  esac\n"
         "  case $path in\n" +
         words +
         "  esac\n"
         "  if [[ $word == -* ]]; then\n"
         "    COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n"
         "  elif [[ -n $commands ]]; then\n"
         "    COMPREPLY=($(compgen -W \"$commands\" -- \"$word\"))\n"
         "  fi\n"
         "}\n"
         "complete -o default -F _setsquare setsquare\n";
}

std::string zsh_completion(const Command& root) {
  std::string script = "#compdef setsquare\n\n";
  for (const Command* command : all_commands(root)) script += zsh_function(*command);
  return script +
         "if [ \"$funcstack[1]\" = _setsquare ]; then\n  _setsquare \"$@\"\nelse\n"
         "  compdef _setsquare setsquare\nfi\n";
}

std::string fish_completion(const Command& root) {
  std::string script = "# fish completion for setsquare\n";
  for (const Command* command : all_commands(root)) script += fish_lines(*command);
  return script;
}

}  // namespace setsquare::app
