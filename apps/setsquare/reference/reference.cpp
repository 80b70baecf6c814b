// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare completion SHELL` and `setsquare manual`: made of the options themselves.
#include <CLI/App.hpp>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "apps/setsquare/command_line/options.hpp"
#include "apps/setsquare/outputs/output_set.hpp"
#include "apps/setsquare/reference/command_tree.hpp"
#include "apps/setsquare/reference/completion.hpp"
#include "apps/setsquare/reference/manual.hpp"
#include "apps/setsquare/subcommands.hpp"
#include "setsquare/core/error.hpp"

namespace setsquare::app {
namespace {

std::string completion_for(const std::string& shell, const Command& root) {
  if (shell == "bash") return bash_completion(root);
  return shell == "zsh" ? zsh_completion(root) : fish_completion(root);
}

const Command& command_named(const std::vector<std::string>& names, const Command& root) {
  std::string path = root.name();
  for (const std::string& name : names) path += " " + name;
  for (const Command* command : all_commands(root)) {
    if (command->joined_path(" ") == path) return *command;
  }
  throw Error("manual: there is no command \"" + path + "\"");
}

void write_all_pages(const std::string& folder, const Command& root) {
  std::vector<std::string> names;
  for (const Command* command : all_commands(root)) names.push_back(manual_file_name(*command));
  OutputSet outputs(folder, names, {});
  for (const Command* command : all_commands(root)) {
    outputs.add(manual_file_name(*command), manual_page(*command));
  }
  outputs.commit();
  std::cout << "written: " << folder << ", " << names.size() << " pages\n";
}

void add_manual(CLI::App& application) {
  struct Options {
    std::vector<std::string> names;
    std::string folder;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* manual = application.add_subcommand("manual", "The manual page of a command, for man");
  manual->add_option("command", options->names, "Whose page: map, evaluate ate; else setsquare's")
      ->type_name("");
  manual->add_option("-o,--output", options->folder, "Write the pages of all commands there")
      ->type_name("DIR");
  manual->footer(
      "Examples:\n"
      "  setsquare manual map | man -l -\n"
      "  setsquare manual -o share/man/man1");
  manual->callback([options, &application] {
    const Command root = command_tree(application);
    if (!options->folder.empty()) {
      write_all_pages(options->folder, root);
    } else {
      std::cout << manual_page(command_named(options->names, root));
    }
  });
}

}  // namespace

void add_reference(CLI::App& application) {
  const auto shell = std::make_shared<std::string>();
  CLI::App* completion = application.add_subcommand(
      "completion", "A script by which a shell completes this command's options");
  completion->add_option("shell", *shell, "For which shell")
      ->transform(one_of({"bash", "zsh", "fish"}))
      ->type_name("bash|zsh|fish")
      ->required();
  completion->footer(
      "Examples:\n"
      "  source <(setsquare completion bash)\n"
      "  setsquare completion zsh > ~/.zsh/_setsquare\n"
      "  setsquare completion fish > ~/.config/fish/completions/setsquare.fish");
  completion->callback(
      [shell, &application] { std::cout << completion_for(*shell, command_tree(application)); });
  add_manual(application);
}

}  // namespace setsquare::app
