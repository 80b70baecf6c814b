// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/scans/log_options.hpp"

#include <CLI/Option.hpp>
#include <filesystem>
#include <functional>
#include <iostream>

#include "apps/setsquare/command_line/options.hpp"
#include "setsquare/core/angle.hpp"

namespace setsquare::app {
namespace {

constexpr const char* kLogGroup = "Reading the log";

CLI::Option* add_log_number(CLI::App& subcommand,
                            const std::string& name,
                            const std::string& unit,
                            const std::string& description,
                            const std::function<void(const double&)>& use) {
  return subcommand.add_option_function<double>(name, use, description)
      ->type_name(unit)
      ->group(kLogGroup);
}

}  // namespace

void add_log_argument(CLI::App& subcommand, std::string& path) {
  subcommand.add_option("log", path, "CARMEN log or MRPT rawlog, plain or gzip; - = stdin")
      ->type_name("")
      ->required();
}

void add_log_options(CLI::App& subcommand, LogOptions& options) {
  subcommand.add_option("--sensor", options.sensor, "Which laser: its name in the log, or \"all\"")
      ->type_name("NAME")
      ->default_str("the front one")
      ->group(kLogGroup);
  add_log_number(
      subcommand,
      "--field-of-view",
      "DEG",
      "Angle that a scan covers whose message carries no angles",
      [&options](double angle_deg) { options.field_of_view_rad = rad_from_deg(angle_deg); })
      ->check(number_above(0.0, 360.0))
      ->default_str("180");
  add_log_number(
      subcommand,
      "--angular-step",
      "DEG",
      "Angle between its beams, negative for clockwise",
      [&options](double angle_deg) { options.bearing_step_rad = rad_from_deg(angle_deg); })
      ->check(number_not_zero(360.0))
      ->default_str("from their number");
  add_log_number(subcommand,
                 "--max-range",
                 "M",
                 "Range from which a beam means \"nothing seen\"",
                 [&options](double range_m) { options.max_range_m = range_m; })
      ->check(number_above(0.0))
      ->default_str("from the log, else 50");
}

std::string title_of_log(const std::string& path) {
  return path == "-" ? "standard input" : std::filesystem::path(path).filename().string();
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
