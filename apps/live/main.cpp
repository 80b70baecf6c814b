// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// setsquare-live: what `setsquare live` and `setsquare replay` start. A program of its own, so that
// the command needs none of the libraries that speak with a robot.
#include <CLI/App.hpp>
#include <csignal>
#include <exception>

#include "apps/live/subcommands.hpp"
#include "apps/setsquare/command_line/parse.hpp"

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // A file beyond the limit is an error of writing.
  std::signal(SIGPIPE, SIG_IGN);  // A peer that went is one, too.
  try {
    CLI::App application{"What a robot has to do with Setsquare while it drives.", "setsquare"};
    setsquare::app::set_help_form(application);
    application.set_version_flag("--version", "setsquare-live " SETSQUARE_VERSION);
    application.require_subcommand(1);
    setsquare::live_app::add_live(application);
    setsquare::live_app::add_replay(application);
    return setsquare::app::parse_and_run(application, argc, argv);
  } catch (const std::exception& error) {
    return setsquare::app::complain(error.what());
  }
}
