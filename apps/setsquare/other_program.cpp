// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/other_program.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "setsquare/core/error.hpp"

namespace setsquare::app {
namespace {

bool is_program(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error) && ::access(path.c_str(), X_OK) == 0;
}

/// In the folder of this command's file, else in a folder of PATH.
std::optional<std::filesystem::path> find_program(const std::string& name) {
  std::error_code error;
  const auto command = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error && is_program(command.parent_path() / name)) {
    return command.parent_path() / name;
  }
  const char* path = std::getenv("PATH");
  std::string_view folders = path != nullptr ? path : "";
  while (!folders.empty()) {
    const std::string_view folder = folders.substr(0, folders.find(':'));
    if (!folder.empty() && is_program(std::filesystem::path(folder) / name)) {
      return std::filesystem::path(folder) / name;
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

std::string what_to_build(const OtherProgram& program) {
  return "it is a program of its own: build it (cmake --build --preset release --target " +
         program.target + ") or install it into the folder of setsquare";
}

void run(const OtherProgram& program, std::vector<std::string> arguments) {
  if (const auto path = find_program(program.name)) start(*path, std::move(arguments));
  const auto is_help = [](const std::string& argument) {
    return argument == "-h" || argument == "--help";
  };
  if (!std::any_of(arguments.begin(), arguments.end(), is_help)) {
    throw FileError(program.name, "is not there; " + what_to_build(program));
  }
  std::cout << program.what_it_does << "\n"
            << program.name << " does it and lists the options; it is not there;\n"
            << what_to_build(program) << ".\n";
}

}  // namespace

void add_other_program(CLI::App& application,
                       const std::string& subcommand,
                       const std::string& description,
                       const OtherProgram& program,
                       const std::vector<std::string>& first_arguments) {
  CLI::App* added = application.add_subcommand(subcommand, description);
  added->prefix_command();
  added->set_help_flag();
  added->callback([added, program, first_arguments] {
    std::vector<std::string> arguments = first_arguments;
    for (const std::string& argument : added->remaining()) arguments.push_back(argument);
    run(program, std::move(arguments));
  });
}

}  // namespace setsquare::app
