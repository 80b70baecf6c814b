// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare experiment ...`: starts setsquare-experiment, a separate program (experiments/),
// which owns the options: the command neither compiles nor links the studies.
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <CLI/App.hpp>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "apps/setsquare/subcommands.hpp"
#include "setsquare/core/error.hpp"

namespace setsquare::app {
namespace {

constexpr const char* kProgram = "setsquare-experiment";
constexpr const char* kWhatToBuild =
    "it is a program of its own: build it (cmake --build --preset release --target "
    "setsquare_experiment) or install it into the folder of setsquare";

bool is_program(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error) && ::access(path.c_str(), X_OK) == 0;
}

/// In the folder of this command's file, else in a folder of PATH.
std::optional<std::filesystem::path> find_program() {
  std::error_code error;
  const auto command = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error && is_program(command.parent_path() / kProgram)) {
    return command.parent_path() / kProgram;
  }
  const char* path = std::getenv("PATH");
  std::string_view folders = path != nullptr ? path : "";
  while (!folders.empty()) {
    const std::string_view folder = folders.substr(0, folders.find(':'));
    if (!folder.empty() && is_program(std::filesystem::path(folder) / kProgram)) {
      return std::filesystem::path(folder) / kProgram;
    }
    folders.remove_prefix(std::min(folders.size(), folder.size() + 1));
  }
  return std::nullopt;
}

/// This process becomes the program; comes back only where that fails.
[[noreturn]] void start(const std::filesystem::path& program, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), program.string());
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  ::execv(program.c_str(), argv.data());
  throw FileError(program, "cannot be started: " + std::generic_category().message(errno));
}

void run_experiment(const std::vector<std::string>& arguments) {
  if (const auto program = find_program()) start(*program, arguments);
  const auto is_help = [](const std::string& argument) {
    return argument == "-h" || argument == "--help";
  };
  if (!std::any_of(arguments.begin(), arguments.end(), is_help)) {
    throw FileError(kProgram, std::string("is not there; ") + kWhatToBuild);
  }
  std::cout << "setsquare experiment paper -o DIR runs the experiments of Bando, Tsubouchi and "
               "Yuta 2014 again.\n"
            << kProgram << " does it and lists the options; it is not there;\n"
            << kWhatToBuild << ".\n";
}

}  // namespace

void add_experiment(CLI::App& application) {
  CLI::App* experiment =
      application.add_subcommand("experiment", "Run experiments on simulated buildings");
  // All that follows goes to the program as it is, --help included.
  experiment->prefix_command();
  experiment->set_help_flag();
  experiment->callback([experiment] { run_experiment(experiment->remaining()); });
}

}  // namespace setsquare::app
