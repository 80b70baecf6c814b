// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "setsquare/eval/error_statistics.hpp"

namespace setsquare::app {

/// {"mean": ..., "rmse": ..., "median": ..., "max": ..., "deviation": ...}, each times `unit`, and
/// "bounds" where there are some; null where there was nothing to measure.
[[nodiscard]] nlohmann::ordered_json json_of_statistics(const ErrorStatistics& statistics,
                                                        double unit);

/// [low, high], each times `unit`.
[[nodiscard]] nlohmann::ordered_json json_of_bound(const ErrorBound& bound, double unit);

/// Two rows under a heading: translation in m, rotation in deg; "-" where there was nothing. Each
/// with its bounds below, and a sentence on them, where there are some.
[[nodiscard]] std::string statistics_table(const ErrorStatistics& translation_m,
                                           const ErrorStatistics& rotation_rad);

/// The same two rows as a table for papers: tab-separated, bounds in columns of their own.
[[nodiscard]] std::string statistics_tsv(const ErrorStatistics& translation_m,
                                         const ErrorStatistics& rotation_rad);

/// --max-time-difference S: how far apart in time two poses of one moment may be. 0.02 s where it
/// is not given.
void add_time_difference_option(CLI::App& subcommand, double& seconds);

}  // namespace setsquare::app
