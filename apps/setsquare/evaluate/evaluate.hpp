// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What `setsquare evaluate` compares. A separate header, since each of these is in another file
// than the command that gathers them.
#pragma once

#include <CLI/App.hpp>

namespace setsquare::app {

void add_evaluate_relations(CLI::App& evaluate);
void add_evaluate_ate(CLI::App& evaluate);
void add_evaluate_rpe(CLI::App& evaluate);
void add_evaluate_closures(CLI::App& evaluate);
void add_evaluate_chains(CLI::App& evaluate);

}  // namespace setsquare::app
