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
constexpr const char* kLogDescription =
    "ROS 1 bag, ROS 2 bag (folder, .db3, .mcap), CARMEN log, CSV, JSON lines or MRPT rawlog; - = stdin";

CLI::Option* add_log_number(CLI::App& subcommand,
                            const std::string& name,
                            const std::string& unit,
                            const std::string& description,
                            const std::function<void(const double&)>& use) {
  return subcommand.add_option_function<double>(name, use, description)
      ->type_name(unit)
      ->group(kLogGroup);
}

void add_window_options(CLI::App& subcommand, LogWindow& window) {
  add_log_number(
      subcommand,
      "--from",
      "S",
      "Leave out what is before: seconds behind the first scan, or a stamp (from 1e8 on)",
      [&window](double from_s) { window.from_s = from_s; })
      ->check(number_from(0.0, 1e11));
  add_log_number(subcommand,
                 "--to",
                 "S",
                 "Leave out what is behind: the same",
                 [&window](double to_s) { window.to_s = to_s; })
      ->check(number_from(0.0, 1e11));
  add_log_number(subcommand,
                 "--rate",
                 "HZ",
                 "At most so many scans per second of each laser",
                 [&window](double rate_hz) { window.max_rate_hz = rate_hz; })
      ->check(number_above(0.0))
      ->default_str("all");
}

}  // namespace

void add_log_argument(CLI::App& subcommand, std::string& path) {
  subcommand.add_option("log", path, kLogDescription)->type_name("")->required();
}

void add_log_arguments(CLI::App& subcommand, std::vector<std::string>& paths) {
  subcommand
      .add_option("log", paths, std::string(kLogDescription) + "; several of one run in their order")
      ->type_name("...")
      ->required();
}

void add_log_options(CLI::App& subcommand, LogOptions& options) {
  subcommand
      .add_option("--sensor,--topic",
                  options.sensor,
                  "Which laser: its name in the log, its topic in a bag, or \"all\"")
      ->type_name("NAME")
      ->default_str("the front one")
      ->group(kLogGroup);
  subcommand
      .add_option("--odometry-topic",
                  options.odometry_topic,
                  "Which odometry of a bag; /tf = the frames odom and base_link")
      ->type_name("TOPIC")
      ->default_str("the likeliest")
      ->group(kLogGroup);
  add_window_options(subcommand, options.window);
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
