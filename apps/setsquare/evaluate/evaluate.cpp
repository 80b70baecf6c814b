// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/evaluate/evaluate.hpp"

#include "apps/setsquare/subcommands.hpp"

namespace setsquare::app {

void add_evaluate(CLI::App& application) {
  CLI::App* evaluate = application.add_subcommand(
      "evaluate", "Compare a trajectory, or the closures of a map, with ground truth");
  evaluate->require_subcommand(1);
  add_evaluate_relations(*evaluate);
  add_evaluate_ate(*evaluate);
  add_evaluate_rpe(*evaluate);
  add_evaluate_closures(*evaluate);
  add_evaluate_chains(*evaluate);
  evaluate->footer(
      "Examples:\n"
      "  setsquare evaluate relations out/trajectory.tum intel.relations\n"
      "  setsquare evaluate ate out/trajectory.tum sim/truth.tum\n"
      "  setsquare evaluate rpe out/trajectory.tum sim/truth.tum --delta-m 10\n"
      "  setsquare evaluate closures out/closures.tsv intel.relations\n"
      "  setsquare evaluate chains intel.relations\n"
      "Each has its own --help.");
}

}  // namespace setsquare::app
