// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The subcommands of `setsquare`. Each function adds one to the application: options, help,
// examples, and a callback that runs it and throws setsquare::Error where it cannot. To add one: a
// folder, a line here and in main.cpp.
#pragma once

#include <CLI/App.hpp>

namespace setsquare::app {

void add_audit(CLI::App& application);
void add_convert(CLI::App& application);
void add_info(CLI::App& application);
void add_live(CLI::App& application);
void add_localize(CLI::App& application);
void add_map(CLI::App& application);
void add_evaluate(CLI::App& application);
void add_experiment(CLI::App& application);
void add_explain(CLI::App& application);
void add_match(CLI::App& application);
void add_merge(CLI::App& application);
void add_reference(CLI::App& application);
void add_render(CLI::App& application);
void add_simulate(CLI::App& application);

}  // namespace setsquare::app
