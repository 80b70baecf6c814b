// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare experiment ...`: starts setsquare-experiment, a separate program (experiments/),
// which owns the options: the command neither compiles nor links the studies.
#include <CLI/App.hpp>

#include "apps/setsquare/other_program.hpp"
#include "apps/setsquare/subcommands.hpp"

namespace setsquare::app {

void add_experiment(CLI::App& application) {
  add_other_program(application,
                    "experiment",
                    "Run experiments on simulated buildings",
                    {.name = "setsquare-experiment",
                     .target = "setsquare_experiment",
                     .what_it_does = "setsquare experiment paper -o DIR runs the experiments of "
                                     "Bando, Tsubouchi and Yuta 2014 again."});
}

}  // namespace setsquare::app
