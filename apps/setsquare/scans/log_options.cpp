// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/scans/log_options.hpp"

#include <CLI/Option.hpp>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "apps/setsquare/command_line/options.hpp"
#include "apps/setsquare/scans/mounting_text.hpp"
#include "setsquare/core/angle.hpp"

namespace setsquare::app {
namespace {

constexpr int kMaxMountings = 64;
constexpr const char* kLogGroup = "Reading the log";
constexpr const char* kLogDescription =
    "ROS 1 bag, ROS 2 bag (folder, .db3, .mcap), CARMEN log, CSV, JSON lines or MRPT rawlog; - = "
    "stdin";

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

CLI::Option* add_log_choice(CLI::App& subcommand,
                            const std::string& name,
                            const std::vector<std::string>& choices,
                            const std::string& description,
                            const std::function<void(const std::string&)>& use) {
  return subcommand.add_option_function<std::string>(name, use, description)
      ->transform(one_of(choices))
      ->type_name(bars_between(choices))
      ->default_str(choices.front())
      ->group(kLogGroup);
}

/// "ring=5", "0.2:1.5" or "auto".
void read_slice(const std::string& text, CloudSlice& slice) {
  slice = {};
  if (text == "auto") return;
  int ring = 0;
  double low_m = 0.0;
  double high_m = 0.0;
  const std::size_t colon = text.find(':');
  if (text.starts_with("ring=") && CLI::detail::lexical_cast(text.substr(5), ring)) {
    slice.ring = ring;
  } else if (colon != std::string::npos &&
             CLI::detail::lexical_cast(text.substr(0, colon), low_m) &&
             CLI::detail::lexical_cast(text.substr(colon + 1), high_m) && low_m < high_m) {
    slice.low_m = low_m;
    slice.high_m = high_m;
  } else {
    throw CLI::ValidationError("--slice", "ring=N, LOW:HIGH in m, or auto; not " + text);
  }
}

void add_message_options(CLI::App& subcommand, LogOptions& options) {
  subcommand
      .add_option_function<std::string>(
          "--slice",
          [&options](const std::string& text) { read_slice(text, options.slice); },
          "Which points of a 3-D scanner: ring=N, or LOW:HIGH above the robot's frame in m")
      ->type_name("SLICE")
      ->default_str("all of a flat cloud, else near the sensor's height")
      ->group(kLogGroup);
  add_log_choice(
      subcommand,
      "--echo",
      {"first", "strongest"},
      "Of a scanner with several echoes per beam",
      [&options](const std::string& echo) { options.takes_strongest_echo = echo == "strongest"; });
}

/// What the rows mean; there from the first of their options on.
AngleDistanceOptions& rows_of(LogOptions& options) {
  if (!options.angle_distance) options.angle_distance.emplace();
  return *options.angle_distance;
}

CLI::Option* add_layout_option(CLI::App& subcommand, LogOptions& options) {
  using Layout = AngleDistanceOptions::Layout;
  const auto use = [&options](const std::string& name) {
    rows_of(options).layout = name == "pairs" ? Layout::kPairs : Layout::kRevolutions;
  };
  return add_log_choice(subcommand,
                        "--layout",
                        {"pairs", "revolutions"},
                        "Rows of angle and distance: a line is a beam, or a revolution",
                        use)
      ->default_str("none");
}

/// What goes with --layout, in any order, and is refused without it.
void add_row_options(CLI::App& subcommand, LogOptions& options, CLI::Option* layout) {
  const auto use_angle_unit = [&options](const std::string& unit) {
    rows_of(options).is_in_degrees = unit == "deg";
  };
  const auto use_range_unit = [&options](const std::string& unit) {
    rows_of(options).range_unit_m = unit == "mm" ? 0.001 : unit == "cm" ? 0.01 : 1.0;
  };
  add_log_choice(subcommand, "--angle-unit", {"deg", "rad"}, "Unit of their angles", use_angle_unit)
      ->needs(layout);
  add_log_choice(
      subcommand, "--range-unit", {"mm", "cm", "m"}, "Unit of their distances", use_range_unit)
      ->needs(layout);
  add_log_number(subcommand,
                 "--scan-rate",
                 "HZ",
                 "Their revolutions per second",
                 [&options](double rate_hz) { rows_of(options).rate_hz = rate_hz; })
      ->check(number_from(0.001, 1e6))
      ->default_str("10")
      ->needs(layout);
  subcommand
      .add_flag_callback(
          "--clockwise",
          [&options] { rows_of(options).is_clockwise = true; },
          "Their angles count clockwise, as RPLIDAR's do")
      ->needs(layout)
      ->group(kLogGroup);
}

/// What mends faults that `info` tells.
void add_log_mending_options(CLI::App& subcommand, LogOptions& options) {
  add_log_number(subcommand,
                 "--range-scale",
                 "FACTOR",
                 "Metres in the log's unit of ranges: 0.001 for mm, 0.01 for cm",
                 [&options](double scale) { options.range_scale = scale; })
      ->check(number_above(0.0, 1e6))
      ->default_str("1");
  subcommand
      .add_option("--ignore-range",
                  options.ignored_ranges_m,
                  "Ranges that are codes and no measurement, in m; may be given several times")
      ->type_name("M")
      ->check(number_above(0.0))
      ->group(kLogGroup);
  subcommand
      .add_flag("--mirror-scans",
                options.mirrors_scans,
                "Exchange left and right: a scanner upside down, or clockwise beams")
      ->group(kLogGroup);
  add_choice<StampUnit, StampUnit>(subcommand,
                                   "--stamp-unit",
                                   options.stamp_unit,
                                   {{"s", StampUnit::kSeconds},
                                    {"ms", StampUnit::kMilliseconds},
                                    {"us", StampUnit::kMicroseconds},
                                    {"ns", StampUnit::kNanoseconds}},
                                   "What the stamps of a log in text count",
                                   "s")
      ->group(kLogGroup);
}

}  // namespace

void add_log_argument(CLI::App& subcommand, std::string& path) {
  subcommand.add_option("log", path, kLogDescription)->type_name("")->required();
}

void add_log_arguments(CLI::App& subcommand, std::vector<std::string>& paths) {
  subcommand
      .add_option(
          "log", paths, std::string(kLogDescription) + "; several of one run in their order")
      ->type_name("...")
      ->required();
}

void add_log_options(CLI::App& subcommand, LogOptions& options) {
  subcommand
      .add_option(
          "--sensor,--topic",
          options.sensor,
          "Which laser: its name in the log, its topic in a bag, several with commas, or \"all\"")
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
  subcommand
      .add_option_function<std::vector<std::string>>(
          "--mounting",
          [&options](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              options.mountings.insert(named_mounting_from_text("--mounting", text));
            }
          },
          "Where a laser is on the robot, in m and degrees; repeated for others")
      ->expected(1, kMaxMountings)
      ->type_name("NAME=X,Y,DEG")
      ->default_str("from the log")
      ->group(kLogGroup);
  add_window_options(subcommand, options.window);
  add_message_options(subcommand, options);
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
  add_log_number(
      subcommand,
      "--sweep-time",
      "S",
      "From a scan's first beam to its last; negative: the last is measured first; 0: all "
      "at once",
      [&options](double sweep_time_s) { options.sweep_time_s = sweep_time_s; })
      ->check(number_from(-10.0, 10.0))
      ->default_str("from the log");
  add_row_options(subcommand, options, add_layout_option(subcommand, options));
  add_log_mending_options(subcommand, options);
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
