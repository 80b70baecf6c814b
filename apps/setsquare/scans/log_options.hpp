// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "setsquare/io/logs/log_reader.hpp"

namespace setsquare::app {

/// Adds the positional argument "log". `path` must outlive the application.
void add_log_argument(CLI::App& subcommand, std::string& path);

/// The same where several logs of one run may be given.
void add_log_arguments(CLI::App& subcommand, std::vector<std::string>& paths);

/// Adds the options by which every subcommand reads a log: --sensor, --mounting, --from, --to,
/// --rate,
/// --field-of-view, --angular-step, --max-range, for rows of angles and distances
/// --layout and what goes with it, and others. `options` must outlive the application.
void add_log_options(CLI::App& subcommand, LogOptions& options);

/// Reports on standard error, at the end of a run, what was wrong with a log: one line for the
/// damaged records, one for each remark. Nothing where nothing was.
void tell_problems(const std::string& path, const LogProblems& problems);

}  // namespace setsquare::app
