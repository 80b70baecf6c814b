// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <exception>
#include <iostream>
#include <string>

#include "apps/setsquare/subcommands.hpp"
#include "setsquare/core/error.hpp"

namespace {

/// Bad file, option or parameter.
constexpr int kExitBadInput = 2;

int complain(std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << "setsquare: " << message << "\n";
  return kExitBadInput;
}

int run(CLI::App& application, int argc, char** argv) {
  try {
    application.parse(argc, argv);
  } catch (const CLI::Success& request) {  // --help, --version
    return application.exit(request);
  } catch (const CLI::ParseError& error) {
    return complain(std::string(error.what()) + " (see --help)");
  }
  if (!std::cout.flush()) return complain("standard output: cannot be written");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    CLI::App application{
        "Setsquare: 2-D laser scans of a building to a map whose walls are straight and square.",
        "setsquare"};
    application.set_version_flag("--version", "setsquare " SETSQUARE_VERSION);
    application.require_subcommand(1);
    application.footer(
        "Examples:\n"
        "  setsquare map intel.clf -o out\n"
        "  setsquare simulate --building office -o sim\n"
        "  setsquare match intel.clf 100 140\n"
        "  setsquare explain intel.clf 100 140 -o match.html\n"
        "  zcat intel.clf.gz | setsquare info -\n"
        "Each subcommand has its own --help.");
    setsquare::app::add_info(application);
    setsquare::app::add_evaluate(application);
    setsquare::app::add_explain(application);
    setsquare::app::add_match(application);
    setsquare::app::add_map(application);
    setsquare::app::add_simulate(application);
    setsquare::app::add_experiment(application);
    return run(application, argc, argv);
  } catch (const std::exception& error) {
    return complain(error.what());
  }
}
