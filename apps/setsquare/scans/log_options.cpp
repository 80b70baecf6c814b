// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/scans/log_options.hpp"

#include <CLI/Option.hpp>
#include <iostream>

#include "setsquare/core/angle.hpp"

namespace setsquare::app {

void add_log_options(CLI::App& subcommand, LogOptions& options) {
  subcommand
      .add_option("--sensor",
                  options.sensor,
                  "Which laser: its name in the log, or \"all\" (default: the front one)")
      ->group("Reading the log");
  subcommand
      .add_option_function<double>(
          "--field-of-view",
          [&options](double angle_deg) { options.field_of_view_rad = rad_from_deg(angle_deg); },
          "Degrees that a scan covers whose message carries no angles (default: 180)")
      ->group("Reading the log");
  subcommand
      .add_option_function<double>(
          "--angular-step",
          [&options](double angle_deg) { options.bearing_step_rad = rad_from_deg(angle_deg); },
          "Degrees between its beams, negative for clockwise (default: from their number)")
      ->group("Reading the log");
  subcommand
      .add_option_function<double>(
          "--max-range",
          [&options](double range_m) { options.max_range_m = range_m; },
          "Metres from which a range means \"nothing seen\" (default: from the log, else 50)")
      ->group("Reading the log");
}

void tell_problems(const std::string& path, const LogProblems& problems) {
  if (problems.num_damaged > 0) {
    std::cerr << "setsquare: " << path << ": " << summary(problems) << "\n";
  }
  for (const std::string& remark : problems.remarks) {
    std::cerr << "setsquare: " << path << ": " << remark << "\n";
  }
}

}  // namespace setsquare::app
