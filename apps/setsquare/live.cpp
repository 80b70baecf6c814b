// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare live ...` and `setsquare replay ...`: start setsquare-live, a separate program
// (apps/live/), which owns the options: the command needs none of the libraries that speak with a
// robot.
#include <CLI/App.hpp>

#include "apps/setsquare/other_program.hpp"
#include "apps/setsquare/subcommands.hpp"

namespace setsquare::app {

namespace {

const OtherProgram kProgram{.name = "setsquare-live",
                            .target = "setsquare_live_app",
                            .what_it_does =
                                "setsquare live maps, or localises, while the robot drives; "
                                "setsquare replay publishes a log as "
                                "a robot would."};

}  // namespace

void add_live(CLI::App& application) {
  add_other_program(
      application, "live", "Map, or localise, while the robot drives", kProgram, {"live"});
  add_other_program(application, "replay", "Publish a log as a robot would", kProgram, {"replay"});
}

}  // namespace setsquare::app
